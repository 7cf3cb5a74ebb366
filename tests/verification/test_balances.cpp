// Balances of many sheared spheres over thousands of steps: momentum is conserved, and what the stress puts in is
// dissipated or stored.
#include <gtest/gtest.h>

#include <cmath>

#include "../small_system.hpp"

namespace stresslet {
namespace {

constexpr double density = 0.1;

Physics frictional(bool drag) {
  Physics physics;
  physics.drag = physics.stresslet = drag;
  physics.contact.stiffness = 2.5e5, physics.contact.friction = 0.5;
  return physics;
}

struct Scheme {
  const char* name;
  double step;
};
std::ostream& operator<<(std::ostream& out, const Scheme& scheme) { return out << scheme.name; }

class MomentumOf : public ::testing::TestWithParam<Scheme> {};

// Pair forces cancel, so CLM (no drag) keeps its momentum. Relative to the mean flow the x component would change with
// the y component, which is zero here; along z all spheres drift together.
TEST_P(MomentumOf, ManySpheresIsKept) {
  constexpr double drift = 0.3;
  ThreadTeam team(1);
  Suspension s = testing::packed_system(60, 0.5, frictional(false),
                                        testing::time_control(GetParam().name, GetParam().step), density);
  double mass = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i) s.state.uz[i] += drift, mass += s.state.mass(i);
  start(s, team);
  testing::advance(s, team, 10'000);
  const Sample end = sample(s, team);
  EXPECT_GT(end.contacts, 5);
  EXPECT_GT(s.builds, 1);
  const Vec3<double> change = end.momentum - Vec3<double>{0, 0, mass * drift};
  EXPECT_LE(norm(change), 1e-10 * mass * drift);
}

INSTANTIATE_TEST_SUITE_P(Schemes, MomentumOf,
                         ::testing::Values(Scheme{"explicit", 5e-6}, Scheme{"semi-implicit", 1e-4}));

class EnergyOf : public ::testing::TestWithParam<Scheme> {};

// Work of all stresses but the stresslet's, which is dissipated around single spheres, against dissipation and the rise
// of elastic and kinetic energy; trapezoidal rule over every step.
TEST_P(EnergyOf, ManySpheresIsAccountedFor) {
  constexpr double strain = 0.05;
  ThreadTeam team(1);
  Suspension s = testing::packed_system(60, 0.5, frictional(true),
                                        testing::time_control(GetParam().name, GetParam().step), density);
  start(s, team);
  testing::advance(s, team, std::int64_t(0.01 / GetParam().step));  // past the first moments, when velocities jump
  const auto steps = std::int64_t(std::round(strain / GetParam().step));
  const auto stored = [](const Sample& m) { return m.elastic_energy + m.kinetic_energy; };
  double work = 0, dissipated = 0, at_start = 0;
  for (std::int64_t n = 0; n <= steps; ++n) {
    if (n > 0) step(s, team);
    const Sample m = sample(s, team);
    if (n == 0) at_start = stored(m);
    const double weight = (n == 0 || n == steps ? 0.5 : 1.0) * GetParam().step;
    work += weight * (m.stress.total().xy - m.stress.stresslet.xy);
    dissipated += weight * m.dissipation();
    if (n == steps) dissipated += stored(m) - at_start;
  }
  EXPECT_GT(work, 0.1);
  EXPECT_NEAR(dissipated / work, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Schemes, EnergyOf, ::testing::Values(Scheme{"explicit", 5e-6}, Scheme{"semi-implicit", 5e-5}));

}  // namespace
}  // namespace stresslet
