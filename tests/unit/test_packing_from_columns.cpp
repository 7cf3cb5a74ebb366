#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/packing/from_columns.hpp"

namespace stresslet {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const Box sheared{BoxKind::lees_edwards, {10, 10, 10}, 2.0, 3.0};
const Box walled{BoxKind::walls, {10, 10, 10}, 2.0, 0};

ParticleColumns three_particles() {
  ParticleColumns c;
  c.x = {1, 4, 7}, c.y = {2, 5, 8}, c.z = {3, 3, 3}, c.radius = {0.5, 0.5, 0.7};
  return c;
}

std::string refusal(const std::function<void(ParticleColumns&)>& spoil, const Box& box = sheared) {
  ParticleColumns c = three_particles();
  spoil(c);
  try {
    state_from_columns(c, box, {}, "start.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(StateFromColumns, FillsWhatTheFileLeavesOut) {
  const ParticleState s = state_from_columns(three_particles(), sheared, {0.1, 0.02}, "start.csv");
  ASSERT_EQ(s.size(), 3u);
  EXPECT_EQ(s.position(1), (Vec3<double>{4, 5, 3}));
  EXPECT_EQ(s.velocity(2), (Vec3<double>{6, 0, 0}));  // 2 (8 - 5)
  EXPECT_EQ(s.angular_velocity(2), (Vec3<double>{0, 0, -1}));
  EXPECT_EQ(s.density[0], 0.1);
  EXPECT_EQ(s.radius[2], 0.7);
  EXPECT_EQ(s.species[2], 0);
  EXPECT_EQ(s.id[2], 2);
}

TEST(StateFromColumns, KeepsWhatTheFileSays) {
  ParticleColumns c = three_particles();
  c.ux = {1, 2, 3}, c.uy = {4, 5, 6}, c.uz = {7, 8, 9}, c.wx = {1, 1, 1}, c.wy = {2, 2, 2}, c.wz = {3, 3, 3};
  c.density = {1, 2, 3}, c.species = {0, 0, 1}, c.id = {40, 7, 12};
  const ParticleState s = state_from_columns(c, sheared, {}, "start.csv");
  EXPECT_EQ(s.velocity(1), (Vec3<double>{2, 5, 8}));
  EXPECT_EQ(s.angular_velocity(1), (Vec3<double>{1, 2, 3}));
  EXPECT_EQ(s.density[2], 3);
  EXPECT_EQ(s.species[2], 1);
  EXPECT_THAT(s.id, testing::ElementsAre(2, 0, 1));
}

TEST(StateFromColumns, BringsParticlesBackIntoTheShearedBox) {
  ParticleColumns c = three_particles();
  c.y[0] = 12, c.z[1] = -1;  // one box up: x - offset, velocity - shear_rate length
  c.ux = {1, 2, 3}, c.uy = {0, 0, 0}, c.uz = {0, 0, 0};
  const ParticleState s = state_from_columns(c, sheared, {}, "start.csv");
  EXPECT_EQ(s.position(0), (Vec3<double>{8, 2, 3}));
  EXPECT_EQ(s.ux[0], 1 - 20);
  EXPECT_EQ(s.z[1], 9);
}

TEST(StateFromColumns, RefusesBadNumbersAndNamesTheParticle) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([&](auto& c) { c.y[1] = nan; }), AllOf(HasSubstr("start.csv: y of particle in row 2 is nan")));
  EXPECT_THAT(refusal([&](auto& c) { c.radius[2] = -0.5; }), HasSubstr("radius of particle in row 3 is -0.5"));
  EXPECT_THAT(refusal([&](auto& c) { c.radius[2] = 0; }), HasSubstr("must be positive"));
  EXPECT_THAT(refusal([&](auto& c) { c.x[0] = HUGE_VAL; }), HasSubstr("x of particle in row 1 is inf"));
  EXPECT_THAT(refusal([&](auto& c) { c.species = {0, -1, 0}; }), HasSubstr("species of particle in row 2"));
  EXPECT_THAT(refusal([&](auto& c) { c.density = {1, 0, 1}; }), HasSubstr("density of particle in row 2"));
}

TEST(StateFromColumns, RefusesBadColumns) {
  EXPECT_THAT(refusal([](auto& c) { c = {}; }), HasSubstr("no particles"));
  EXPECT_THAT(refusal([](auto& c) { c.radius.pop_back(); }), HasSubstr("2 entries of radius for 3"));
  EXPECT_THAT(refusal([](auto& c) { c.ux = {1, 2, 3}; }), HasSubstr("0 entries of uy for 3"));
  EXPECT_THAT(refusal([](auto& c) { c.wz = {1, 2, 3}; }), HasSubstr("0 entries of wx for 3"));
  EXPECT_THAT(refusal([](auto& c) { c.id = {5, 3, 5}; }), HasSubstr("id 5 occurs in rows 1 and 3"));
}

TEST(StateFromColumns, RefusesOverlapsAlsoAcrossTheShearedFace) {
  const auto overlap = [](auto& c) {
    c.id = {11, 22, 33};
    // Row 1 one box up sits at x = 4.2 with offset 3: 0.9 above row 3 in y and 0 in x and z, contact at 1.2.
    c.x[0] = 1.2, c.y[0] = 0.4, c.x[2] = 4.2, c.y[2] = 9.5;
  };
  EXPECT_THAT(refusal(overlap), AllOf(HasSubstr("row 1 (id 11)"), HasSubstr("row 3 (id 33)"), HasSubstr("by 0.6")));
  EXPECT_EQ(refusal([](auto& c) { c.x[1] = 1.995, c.y[1] = 2; }), "no error");  // 1 % of the radius
  EXPECT_THAT(refusal([](auto& c) { c.x[1] = 1.985, c.y[1] = 2; }), HasSubstr("overlap by 0.03"));
}

TEST(StateFromColumns, RefusesWhatLiesInAWall) {
  EXPECT_THAT(refusal([](auto& c) { c.y[0] = -0.1; }, walled), HasSubstr("particle in row 1 lies at y = -0.1"));
  EXPECT_THAT(refusal([](auto& c) { c.y[0] = 0.4; }, walled), HasSubstr("overlaps a wall by 0.2"));
  EXPECT_EQ(refusal([](auto& c) { c.y[0] = 0.5; }, walled), "no error");
}

}  // namespace
}  // namespace stresslet
