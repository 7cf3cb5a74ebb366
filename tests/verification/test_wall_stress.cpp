/// A lubricated suspension between walls and without drag: nothing but the walls moves it, so that their forces, and
/// what momentum the spheres store, are the summed stress, of which neither knows the first moments.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

/// x of the forces on the spheres, of the upper wall less those of the lower, half, over the area.
double stress_at_walls(const Suspension& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i) {
    Twist<double> wrench;
    s.walls.add_to<true>(i, {s.state.velocity(i), s.state.angular_velocity(i)}, wrench);
    sum += 0.5 * s.walls[i].normal_y * wrench.linear.x;
    if (const auto& contact = s.wall_contacts[i]; contact.normal_y != 0)
      sum += 0.5 * contact.normal_y * contact.result.force.x;
  }
  return sum / (s.box.length.x * s.box.length.z);
}

double stored_momentum(const Suspension& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i) {
    const double y = s.state.y[i];
    sum += s.state.mass(i) * (y - 0.5 * s.box.length.y) * (s.state.ux[i] - 0.5 * s.box.mean_flow(y));
  }
  return sum / s.box.volume();
}

class WallStress : public ::testing::TestWithParam<const char*> {};

TEST_P(WallStress, IsTheSummedStress) {
  const Case settled = std::get<Case>(read_any_case_text(
      "", "walls",
      {"flow.boundary=walls", "suspension.solid_fraction=0.45", "suspension.count=60", "run.strain=1", "model.name=CLM",
       "flow.stokes=0.01", "lubrication.outer_cutoff=0.3", std::string("contact.friction=") + GetParam()}));
  Suspension s = make_suspension(settled, make_plan(settled), {});
  ThreadTeam team(1);
  start(s, team);
  while (s.strain < 0.3) step(s, team);
  const double begin = s.strain, stored = stored_momentum(s);
  double walls = 0, summed = 0;
  constexpr int steps = 1000;
  for (int n = 0; n < steps; ++n) {
    step(s, team);
    walls += stress_at_walls(s) / steps;
    summed += sample(s, team).stress.total().xy / steps;
  }
  const double growth = (stored_momentum(s) - stored) / (s.strain - begin);
  EXPECT_NEAR((summed + growth) / walls, 1, 0.01);
  EXPECT_GT(walls, 1);
}

INSTANTIATE_TEST_SUITE_P(Friction, WallStress, ::testing::Values("0", "0.5"));

}  // namespace
}  // namespace stresslet
