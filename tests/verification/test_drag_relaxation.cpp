// Single spheres in a sheared viscous flow, far apart: velocities relax over m/(6 pi a), spins over I/(8 pi a^3).
#include <gtest/gtest.h>

#include <cmath>

#include "../small_system.hpp"

namespace stresslet {
namespace {

using testing::Sphere;

/// Velocity relative to the mean flow and spin relative to its rotation, at time t, by the equations of motion in the
/// flow u_x = y - 10: c = (c0 - u_y0 t, u_y0, u_z0) exp(-t/tau).
class DragRelaxation : public ::testing::TestWithParam<const char*> {};

TEST_P(DragRelaxation, FollowsTheExponential) {
  constexpr double density = 2, length = 20;
  const Box box{BoxKind::lees_edwards, {length, length, length}, 1, 0};
  // The second leaves through the sheared face at y = 20, the third through the one at y = 0.
  const std::vector<Sphere> spheres{{{4, 5, 4}, 0.5, {2, 0, 0.5}, {1, 2, 3}},
                                    {{14, 19.99, 4}, 0.7, {10, 0.7, -0.5}, {0, 0, 1}},
                                    {{8, 0.02, 14}, 1.0, {-8, -0.9, 0.2}, {-1, 0, -0.5}}};
  Physics physics;
  const double tau = 2.0 / 9.0 * density * 0.25;  // of the smallest sphere
  const int steps = 4000;
  const double dt = 2 * tau / steps, t = 2 * tau;
  Suspension s = testing::small_system(box, spheres, physics, testing::time_control(GetParam(), dt, 1e-12), density);
  ThreadTeam team(1);
  start(s, team);
  testing::advance(s, team, steps);

  const bool half_step_behind = s.time.scheme == "explicit";
  for (std::size_t id = 0; id < spheres.size(); ++id) {
    const Sphere& begin = spheres[id];
    const std::size_t i = testing::index_of(s, std::int32_t(id));
    const double a = begin.radius, decay = std::exp(-t / (2.0 / 9.0 * density * a * a)),
                 spin_decay = std::exp(-t / (density * a * a / 15));
    const double c0 = begin.velocity.x - (begin.position.y - length / 2);
    const Vec3<double> expected{(c0 - begin.velocity.y * t) * decay, begin.velocity.y * decay,
                                begin.velocity.z * decay};
    const Vec3<double> spin = (begin.angular_velocity - Vec3<double>{0, 0, -0.5}) * spin_decay;
    // Velocities lie half a step later in the explicit scheme; the difference is inside the bound of first order.
    const Vec3<double> found{s.state.ux[i] - (s.state.y[i] - length / 2), s.state.uy[i], s.state.uz[i]};
    const double bound = 3e-3;
    EXPECT_NEAR(found.x, expected.x, bound * std::abs(c0)) << id;
    EXPECT_NEAR(found.y, expected.y, bound * 1) << id;
    EXPECT_NEAR(found.z / expected.z, 1, bound) << id;
    EXPECT_NEAR(s.state.wx[i], spin.x, bound * norm(begin.angular_velocity)) << id;
    EXPECT_NEAR(s.state.wy[i], spin.y, bound * norm(begin.angular_velocity)) << id;
    EXPECT_NEAR(s.state.wz[i] + 0.5, spin.z, bound * norm(begin.angular_velocity)) << id;
  }
  EXPECT_LT(s.state.y[testing::index_of(s, 1)], 1);
  EXPECT_GT(s.state.y[testing::index_of(s, 2)], 19);

  // Explicit steps decay as (1 - dt/tau)^n, implicit ones as (1 + dt/tau)^-n: one below the exponential, one above.
  const double k = dt / tau, found = s.state.uz[testing::index_of(s, 0)] / 0.5;
  const double discrete = half_step_behind ? (1 - k / 2) * std::pow(1 - k, steps) : std::pow(1 + k, -steps - 1);
  EXPECT_NEAR(found / discrete, 1, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Schemes, DragRelaxation, ::testing::Values("explicit", "semi-implicit"));

}  // namespace
}  // namespace stresslet
