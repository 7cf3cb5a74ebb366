/// Two spheres that share cells, squeezed together: the force must not depend on the relaxation time, which it does
/// without the friction between solids in a cell.
#include <gtest/gtest.h>

#include <algorithm>

#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"

namespace stresslet {
namespace {

struct Push {
  double with_friction, without;  ///< along the approach, over viscosity, radius and speed
};

Push squeezing_force(double relaxation_time, double gap) {
  constexpr int edge = 24;
  constexpr double radius = 5, speed = 1e-5;
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.collision = "TRT";
  setup.rates.relaxation_time = relaxation_time;
  setup.rates.magic_parameter = 1.0 / 12;
  ResolvedFluidOf<double> fluid(setup, {});
  ThreadTeam team(1);
  fluid.initialise(team, [](const Cells&) { return CellState{}; });
  const double half = radius + gap / 2;
  const std::vector<ResolvedSphere> spheres{{{11.3 - half, 11.8, 12.1}, radius, {speed, 0, 0}, {}},
                                            {{11.3 + half, 11.8, 12.1}, radius, {-speed, 0, 0}, {}}};
  const double scale = kinematic_viscosity_lu(relaxation_time) * radius * speed;
  Push push{};
  // The flow has settled to 1e-4: vorticity spreads over the box, sound waves have died away.
  const int steps = int(std::max(200 / kinematic_viscosity_lu(relaxation_time), 1600.0));
  team.run([&](Member& member) {
    for (int n = 0; n < steps; ++n) {
      fluid.prepare(member, spheres);
      if (n + 1 < steps) fluid.sweep(member, spheres);
    }
  });
  push.without = -load_on_sphere(fluid.exchange(0), spheres[0].velocity, {}).force.x / scale;
  push.with_friction = push.without;
  for (const PointFriction& friction : fluid.friction()) push.with_friction += 2 * speed * friction.coefficient / scale;
  return push;
}

TEST(LongClosePair, ForceDoesNotDependOnTheRelaxationTime) {
  const Push slow = squeezing_force(0.6, 0.05), middle = squeezing_force(1, 0.05), fast = squeezing_force(2, 0.05);
  EXPECT_NEAR(slow.with_friction / middle.with_friction, 1, 5e-4);
  EXPECT_NEAR(fast.with_friction / middle.with_friction, 1, 5e-4);
  EXPECT_GT(slow.without / fast.without, 1.0015) << "friction decides";
}

}  // namespace
}  // namespace stresslet
