/// Disturbances inside spheres die out where they are fed most: in a sphere that the sheared plane cuts.
/// Where the core of the sphere is not damped, bounce-back lets them grow without bound, as holdych always does.
#include <gtest/gtest.h>

#include <algorithm>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {
namespace {

class SolidCore : public ::testing::TestWithParam<std::string> {};

TEST_P(SolidCore, FeedsNoDisturbance) {
  constexpr int edge = 16;
  constexpr double shear_velocity_lu = 0.09, shear_rate = shear_velocity_lu / edge;
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.grid.closure[1] = Closure::sheared;
  setup.shear_velocity_lu = shear_velocity_lu;
  setup.rates.relaxation_time = 2;
  setup.rates.magic_parameter = 1.0 / 12;
  CouplingSetup coupling;
  coupling.coupling_operator = GetParam();
  coupling.solid.weight = "linear";
  const auto fluid = ResolvedFluid::make(setup, coupling);

  const auto mean_flow = [&](double y) { return shear_rate * (y - 0.5 * (edge - 1)); };
  const Vec3<double> centre{7.6, -0.5, 8.1};
  const std::vector<ResolvedSphere> spheres{{centre, 5, {mean_flow(centre.y), 0, 0}, {0, 0, -0.5 * shear_rate}}};
  ThreadTeam team(1);
  fluid->initialise(team, [&](const Cells& c) {
    CellState s;
    s.velocity.x = mean_flow(c[1]);
    return s;
  });
  const auto widest_density_range = [&](int steps) {
    double widest = 0;
    for (int n = 0; n < steps; ++n) {
      team.run([&](Member& member) {
        fluid->prepare(member, spheres);
        fluid->sweep(member, spheres);
      });
      if (n % 20 > 0) continue;
      const auto range = fluid->totals(team);
      widest = std::max(widest, range.highest_density - range.lowest_density);
    }
    return widest;
  };
  widest_density_range(400);
  const double early = widest_density_range(400);
  widest_density_range(2400);
  const double late = widest_density_range(400);
  EXPECT_NEAR(late / early, 1, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Coupling, SolidCore,
                         ::testing::Values("superposition", "guo-form", "bounce-back", "half-holdych"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace stresslet
