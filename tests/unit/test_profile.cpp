#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/rheology/profile.hpp"

namespace stresslet {
namespace {

Box box_of(BoxKind kind, double shear_rate = 1) { return {kind, {3, 6, 4}, shear_rate, 0.7}; }

struct Spheres {
  std::vector<double> y, ux, radius;
  double volume() const {
    double sum = 0;
    for (double a : radius) sum += 4.0 / 3.0 * pi * a * a * a;
    return sum;
  }
};

/// Random spheres, inside the walls where there are some, moving with the mean flow.
Spheres affine_spheres(const Box& box, std::size_t n) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform;
  Spheres s;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 0.05 + 0.9 * uniform(random);
    const double margin = box.periodic_in_y() ? 0 : a;
    s.radius.push_back(a);
    s.y.push_back(margin + (box.length.y - 2 * margin) * uniform(random));
    s.ux.push_back(box.mean_flow(s.y.back()));
  }
  return s;
}

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

TEST(SphereVolumeBetween, ClosedForms) {
  EXPECT_NEAR(sphere_volume_between(2, -9, 9), 4.0 / 3.0 * pi * 8, 1e-13);
  EXPECT_NEAR(sphere_volume_between(2, 0, 2), 2.0 / 3.0 * pi * 8, 1e-13);
  // Cap of height h: pi h^2 (3 a - h) / 3.
  EXPECT_NEAR(sphere_volume_between(2, 1.5, 7), pi * 0.25 * (6 - 0.5) / 3, 1e-14);
  EXPECT_NEAR(sphere_volume_between(2, -7, -1.5), pi * 0.25 * (6 - 0.5) / 3, 1e-14);
  EXPECT_NEAR(sphere_volume_between(2, 2, 3), 0, 1e-14);
  // A very thin cap keeps its relative accuracy.
  EXPECT_NEAR(sphere_volume_between(2, -3, -2 + 0x1p-30) / (pi * 0x1p-60 * 2), 1, 1e-9);
  // Thin slab about the centre: its cross-section times its height, to second order.
  EXPECT_NEAR(sphere_volume_between(2, -1e-4, 1e-4) / (pi * 4 * 2e-4), 1, 1e-8);
}

class ProfileInEveryBox : public testing::TestWithParam<BoxKind> {};

TEST_P(ProfileInEveryBox, SlabsSumToTheSolidFraction) {
  const Box box = box_of(GetParam());
  const Spheres s = affine_spheres(box, 300);
  for (std::size_t slabs : {1u, 2u, 7u, 100u}) {
    ShearProfile profile(box, slabs);
    profile.add(s.y, s.ux, s.radius);
    profile.add(s.y, s.ux, s.radius);
    const double mean = sum(profile.solid_fraction()) / double(slabs);
    EXPECT_NEAR(mean / (s.volume() / box.volume()), 1, 1e-13) << slabs;
  }
}

INSTANTIATE_TEST_SUITE_P(Boxes, ProfileInEveryBox,
                         testing::Values(BoxKind::lees_edwards, BoxKind::periodic, BoxKind::walls),
                         [](const auto& box) {
                           return box.param == BoxKind::walls      ? "walls"
                                  : box.param == BoxKind::periodic ? "periodic"
                                                                   : "lees_edwards";
                         });

TEST(Profile, SlabsAgreeWithSamplingOfTheSphere) {
  // A sphere across the lower face: its image fills the upper slabs and moves faster by the jump.
  const Box box = box_of(BoxKind::lees_edwards, 2.0);
  const double y = 0.3, a = 0.8, u = 0.25;
  const std::size_t slabs = 12;  // of height 0.5
  ShearProfile profile(box, slabs);
  profile.add(std::vector{y}, std::vector{u}, std::vector{a});
  std::vector<double> sampled(slabs, 0.0);
  const int layers = 200000;
  for (int k = 0; k < layers; ++k) {
    const double h = -a + 2 * a * (k + 0.5) / layers;
    const double height = y + h < 0 ? y + h + box.length.y : y + h;
    sampled[std::size_t(height / 0.5)] += pi * (a * a - h * h) * 2 * a / layers;
  }
  const std::vector<double> fraction = profile.solid_fraction(), velocity = profile.velocity();
  for (std::size_t k = 0; k < slabs; ++k) {
    EXPECT_NEAR(fraction[k] * 3 * 4 * 0.5, sampled[k], 1e-4) << k;
    if (k >= 11) {
      EXPECT_DOUBLE_EQ(velocity[k], u + 2.0 * 6) << k;
    } else if (k <= 2) {
      EXPECT_DOUBLE_EQ(velocity[k], u) << k;
    } else {
      EXPECT_TRUE(std::isnan(velocity[k])) << k;
    }
  }
}

TEST(Profile, SphereAcrossTheUpperFaceIsSlowerBelow) {
  const Box box = box_of(BoxKind::lees_edwards, 2.0);
  ShearProfile profile(box, 3);
  profile.add(std::vector{5.9}, std::vector{5.0}, std::vector{0.5});
  EXPECT_DOUBLE_EQ(profile.velocity()[2], 5.0);
  EXPECT_DOUBLE_EQ(profile.velocity()[0], 5.0 - 12.0);
  EXPECT_NEAR(profile.solid_fraction()[0] * 3 * 4 * 2, pi * 0.16 * (1.5 - 0.4) / 3, 1e-14);  // cap of height 0.4
}

TEST(Profile, PlainPeriodicImageHasTheSameVelocity) {
  ShearProfile profile(box_of(BoxKind::periodic, 2.0), 3);
  profile.add(std::vector{5.9}, std::vector{5.0}, std::vector{0.5});
  EXPECT_DOUBLE_EQ(profile.velocity()[0], 5.0);
}

TEST(Profile, SpherePressedIntoAWallCountsToItsSlab) {
  ShearProfile profile(box_of(BoxKind::walls), 6);
  profile.add(std::vector{0.45, 5.6}, std::vector{0.0, 0.0}, std::vector{0.5, 0.5});
  const std::vector<double> fraction = profile.solid_fraction();
  EXPECT_NEAR(fraction[0] * 12, pi / 6, 1e-14);
  EXPECT_NEAR(fraction[5] * 12, pi / 6, 1e-14);
  for (std::size_t k = 1; k < 5; ++k) EXPECT_EQ(fraction[k], 0) << k;
}

TEST(Profile, AffineMotionHasSlopeOne) {
  for (BoxKind kind : {BoxKind::lees_edwards, BoxKind::walls}) {
    const Box box = box_of(kind, 0.37);
    const Spheres s = affine_spheres(box, 500);
    ShearProfile profile(box, 10);
    for (int frame = 0; frame < 3; ++frame) profile.add(s.y, s.ux, s.radius);
    EXPECT_NEAR(profile.velocity_slope(), 1, 1e-13);
  }
}

TEST(Profile, AffineSheathOfEqualSpheresOnALatticeIsAffineInTheSlabs) {
  // Centres in the middle of every slab, radius half a slab: each slab holds one sphere and its velocity.
  const Box box = box_of(BoxKind::lees_edwards);
  ShearProfile profile(box, 6);
  std::vector<double> y, u, a;
  for (int k = 0; k < 6; ++k) y.push_back(k + 0.5), u.push_back(box.mean_flow(k + 0.5)), a.push_back(0.5);
  profile.add(y, u, a);
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_NEAR(profile.height()[k], y[k], 1e-14);
    EXPECT_NEAR(profile.velocity()[k], u[k], 1e-13);
    EXPECT_NEAR(profile.solid_fraction()[k], pi / 6 / 12, 1e-15);
  }
}

TEST(Profile, SlopeIsTheWeightedLeastSquaresOne) {
  // Three spheres; volumes 1 : 8 : 1 in proportion, heights 1, 2, 3, velocities 0, 5, 4: slope (4 - 0) / 2.
  ShearProfile profile(box_of(BoxKind::walls), 4);
  profile.add(std::vector{1.0, 2.0, 3.0}, std::vector{0.0, 5.0, 4.0}, std::vector{0.2, 0.4, 0.2});
  EXPECT_NEAR(profile.velocity_slope(), 2, 1e-13);
  ShearProfile flat(box_of(BoxKind::walls), 4);
  EXPECT_EQ(flat.velocity_slope(), 0);
  flat.add(std::vector{1.0}, std::vector{3.0}, std::vector{0.2});
  EXPECT_EQ(flat.velocity_slope(), 0);
}

TEST(Profile, ContinuesFromItsSums) {
  const Box box = box_of(BoxKind::lees_edwards);
  const Spheres s = affine_spheres(box, 50);
  ShearProfile unbroken(box, 5), first(box, 5), second(box, 5);
  unbroken.add(s.y, s.ux, s.radius);
  first.add(s.y, s.ux, s.radius);
  second.restore(first.sums());
  unbroken.add(s.ux, s.y, s.radius);
  second.add(s.ux, s.y, s.radius);
  EXPECT_EQ(second.velocity(), unbroken.velocity());
  EXPECT_EQ(second.solid_fraction(), unbroken.solid_fraction());
  EXPECT_EQ(second.velocity_slope(), unbroken.velocity_slope());
}

}  // namespace
}  // namespace stresslet
