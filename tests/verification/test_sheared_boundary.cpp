// A pair that straddles the sheared face behaves as the same pair in the bulk: forces, torques, history and stress.
#include <gtest/gtest.h>

#include <cmath>

#include "../small_system.hpp"

namespace stresslet {
namespace {

using testing::Sphere;

/// Short, because what a velocity of order `length` is rounded by, a film amplifies into a force.
constexpr double length = 4;

/// Moves spheres up by `rise` and along by `advance` in the mean flow u_x = y - length/2, and by hand to the images
/// inside the box whose upper image is displaced by `offset`. Sheared flow looks the same from the new place.
std::vector<Sphere> displaced(std::vector<Sphere> spheres, double rise, double advance, double offset) {
  for (Sphere& s : spheres) {
    s.position.x += advance, s.position.y += rise;
    s.velocity.x += rise;
    if (s.position.y >= length) s.position.y -= length, s.position.x -= offset, s.velocity.x -= length;
    s.position.x -= length * std::floor(s.position.x / length);
  }
  return spheres;
}

struct PairState {
  Vec3<double> force, torque1, torque2, history;
  StressParts stress;
  double dissipation, energy;
  bool across;
};

PairState state_of(Suspension& s, ThreadTeam& team) {
  PairState r{};
  const std::size_t i = testing::index_of(s, 0), j = testing::index_of(s, 1);
  TwistVector twist = s.velocity;
  for (const std::size_t k : {i, j}) twist.set(k, s.state.velocity(k), s.state.angular_velocity(k));
  team.run([&](Member& member) { s.lubrication.apply<true>(member, s.pairs, twist); });
  Twist<double> on_i{}, on_j{};
  s.contacts.add_to(i, s.pairs, on_i), s.lubrication.add_to(i, s.pairs, on_i);
  s.contacts.add_to(j, s.pairs, on_j), s.lubrication.add_to(j, s.pairs, on_j);
  EXPECT_EQ(s.pairs.size(), 1u);
  r.force = on_i.linear, r.torque1 = on_i.angular, r.torque2 = on_j.angular;
  r.history = s.list.i[0] == std::int32_t(i) ? s.history.get(0) : -s.history.get(0);
  const Sample sampled = sample(s, team);
  r.stress = sampled.stress, r.dissipation = sampled.dissipation(), r.energy = sampled.elastic_energy;
  r.across = std::abs(s.state.y[i] - s.state.y[j]) > length / 2;
  return r;
}

struct Condition {
  const char* scheme;
  const char* lubrication;
  double overlap;  // at the start
};

class ShearedBoundary : public ::testing::TestWithParam<Condition> {
 protected:
  /// Soft contacts: a position of order 1 is known to 1e-16, and stiffness amplifies that into forces.
  static constexpr double stiffness = 100;
  /// So thin that the list is rebuilt, and the history carried over, several times in a run.
  static constexpr double rebuilding_skin = 2e-3;

  static Suspension pair(double rise, double advance, double offset) {
    const Condition c = GetParam();
    const double a1 = 0.5, a2 = 0.7, distance = a1 + a2 - c.overlap;
    const Vec3<double> e = Vec3<double>{-2, 2, 1} / 3.0, middle{1.5, 1.5, 1.5};
    std::vector<Sphere> spheres{{middle - 0.5 * distance * e, a1, {-0.7, 0.1, -0.2}, {0.3, -1, -0.4}},
                                {middle + 0.5 * distance * e, a2, {0.2, -0.2, 0.3}, {-0.5, 0.7, 0.1}}};
    Physics physics;
    physics.lubrication_law = c.lubrication;
    physics.drag = true;
    physics.contact.stiffness = stiffness, physics.contact.friction = 1, physics.contact.damping_ratio = 0.1;
    const Box box{BoxKind::lees_edwards, {length, length, length}, 1, offset};
    return testing::small_system(box, displaced(spheres, rise, advance, offset), physics,
                                 testing::time_control(c.scheme, 2e-5, 1e-11), 0.5, rebuilding_skin);
  }
};

void expect_equal(const PairState& a, const PairState& b) {
  const double tolerance = 1e-12;
  const double force = std::max(norm(a.force), 1.0);
  EXPECT_LE(norm(a.force - b.force), tolerance * force);
  EXPECT_LE(norm(a.torque1 - b.torque1), tolerance * force);
  EXPECT_LE(norm(a.torque2 - b.torque2), tolerance * force);
  EXPECT_LE(norm(a.history - b.history), tolerance);
  EXPECT_NEAR(a.dissipation, b.dissipation, tolerance * std::max(1.0, a.dissipation));
  EXPECT_NEAR(a.energy, b.energy, tolerance);
  std::vector<Stress> parts;
  StressParts::for_each(b.stress, [&](const char*, const Stress& part) { parts.push_back(part); });
  std::size_t n = 0;
  StressParts::for_each(a.stress, [&](const char* name, const Stress& part) {
    const Stress d = part - parts[n++];
    for (const double v : {d.xx, d.yy, d.zz, d.xy, d.xz, d.yz}) EXPECT_LE(std::abs(v), tolerance * force) << name;
  });
}

TEST_P(ShearedBoundary, IsInvisibleToAPairWhateverItsOffset) {
  ThreadTeam team(1);
  constexpr int steps = 1600;
  Suspension bulk = pair(0, 0, 0);
  start(bulk, team);
  testing::advance(bulk, team, steps);
  const PairState expected = state_of(bulk, team);
  ASSERT_GT(bulk.builds, 3);
  ASSERT_FALSE(expected.across);
  EXPECT_GT(norm(expected.force), 1e-2);
  if (GetParam().overlap > 0) {
    EXPECT_GT(norm(expected.history), 1e-4);
  }

  for (const double offset : {0.0, 0.15, 1.35, 1.99995, 2.00005, 3.05, 3.99975}) {
    Suspension across = pair(2.5, 1.3, offset);
    start(across, team);
    testing::advance(across, team, steps);
    const PairState found = state_of(across, team);
    EXPECT_TRUE(found.across);
    SCOPED_TRACE(offset);
    expect_equal(expected, found);
  }
}

INSTANTIATE_TEST_SUITE_P(Contact, ShearedBoundary,
                         ::testing::Values(Condition{"explicit", "none", 0.05},
                                           Condition{"semi-implicit", "none", 0.05},
                                           Condition{"explicit", "complete", 0.05},
                                           Condition{"semi-implicit", "complete", 0.05},
                                           Condition{"inertialess", "complete", 0.05}));
INSTANTIATE_TEST_SUITE_P(Film, ShearedBoundary,
                         ::testing::Values(Condition{"explicit", "complete", -0.02},
                                           Condition{"semi-implicit", "complete", -0.02},
                                           Condition{"semi-implicit", "normal", -0.02},
                                           Condition{"semi-implicit", "grand-resistance", -0.02},
                                           Condition{"inertialess", "complete", -0.02}));

// Equal steps round in the same direction; their error must not add up to a shear rate of its own.
TEST(ShearedBox, OffsetStaysExactOverManySteps) {
  Box box{BoxKind::lees_edwards, {7.3, 6.1, 5}, 1, 0};
  const double step = 1e-4 / 3, per_step = 6.1 * step;
  for (int n = 0; n < 1'000'000; ++n) box.advance(step);
  const long double exact = std::fmod(1'000'000 * (long double)per_step, (long double)box.length.x);
  EXPECT_NEAR(box.offset, double(exact), 2e-15);
}

// Dry elastic spheres that meet across the sheared face: the energy in the frame of the pair, kinetic by the velocity
// of the image plus elastic, is what it was before, and so is momentum.
TEST(ElasticPair, KeepsItsEnergyAcrossTheShearedFace) {
  const double stiffness = 1e4, density = 1, a1 = 0.5, a2 = 0.6;
  const double m1 = density * 4 / 3 * pi * a1 * a1 * a1, m2 = density * 4 / 3 * pi * a2 * a2 * a2;
  const double duration = pi * std::sqrt(m1 * m2 / (m1 + m2) / stiffness), dt = duration / 2000;
  for (const double offset : {0.0, 1.55, 3.35}) {
    const std::vector<Sphere> spheres{{{2, 3.5, 2}, a1, {2, 1, 0.2}}, {{2.2, 4.7, 2.1}, a2, {2.5, -1, 0}}};
    ContactParameters contact;
    contact.stiffness = stiffness;
    const Box box{BoxKind::lees_edwards, {length, length, length}, 1, offset};
    Suspension s = testing::small_system(box, displaced(spheres, 0, 0, offset), testing::dry(contact),
                                         testing::time_control("explicit", dt), density);
    ThreadTeam team(1);
    start(s, team);
    double largest_overlap = 0;
    for (int n = 0; n < 5 * 2000; ++n) {
      step(s, team);
      if (s.pairs.size() > 0) largest_overlap = std::max(largest_overlap, -s.pairs.gap[0]);
    }
    EXPECT_GT(largest_overlap, 5e-3);
    EXPECT_EQ(s.pairs.size(), 0u);
    const std::size_t i = testing::index_of(s, 0), j = testing::index_of(s, 1);
    Vec3<double> u1 = s.state.velocity(i), u2 = s.state.velocity(j);
    if (s.state.y[i] < length / 2) u1.x += length;
    if (s.state.y[j] < length / 2) u2.x += length;
    const Vec3<double> before1 = spheres[0].velocity, before2 = spheres[1].velocity;
    const double energy = 0.5 * (m1 * dot(u1, u1) + m2 * dot(u2, u2)),
                 before = 0.5 * (m1 * dot(before1, before1) + m2 * dot(before2, before2));
    const double relative_energy = 0.5 * m1 * m2 / (m1 + m2) * dot(before2 - before1, before2 - before1);
    EXPECT_GT(norm(u1 - before1), 0.5);
    EXPECT_NEAR((energy - before) / relative_energy, 0, 1e-5);
    EXPECT_LE(norm(m1 * (u1 - before1) + m2 * (u2 - before2)), 1e-12);
  }
}

}  // namespace
}  // namespace stresslet
