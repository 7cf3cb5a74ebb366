/// Drag of a simple cubic array of fixed spheres against Zick & Homsy, J. Fluid Mech. 115 (1982) 13 (recomputed
/// digits): K = F / (6 pi mu a U), U the mean velocity over the whole cell, F the force with its mean pressure
/// gradient.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {
namespace {

constexpr int edge = 16;
constexpr double radius = 5;
/// At solid fraction 4 pi/3 (5/16)^3: the table between d/L = 0.6 and 0.7, interpolated (to 1e-5).
constexpr double exact = 4.36973;

struct Array {
  double drag, imbalance;
};

Array cubic_array(double relaxation_time, const Vec3<double>& centre, const CouplingSetup& coupling = {},
                  const std::string& collision = "TRT") {
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.collision = collision;
  setup.rates.relaxation_time = relaxation_time;
  setup.rates.magic_parameter = 1.0 / 12;
  ResolvedFluidOf<double> fluid(setup, coupling);
  const double viscosity = kinematic_viscosity_lu(relaxation_time), volume = double(edge) * edge * edge;
  const double force = 1e-6 * viscosity;
  fluid.lattice().input.force_density = {force, 0, 0};
  ThreadTeam team(1);
  fluid.initialise(team, [](const Cells&) { return CellState{}; });
  const std::vector<ResolvedSphere> spheres{{centre, radius, {}, {}}};
  double before = 0, mean = 1;
  while (std::abs(mean - before) > 2e-6 * std::abs(mean)) {
    before = mean;
    team.run([&](Member& member) {
      for (int n = 0; n < 50; ++n) {
        fluid.prepare(member, spheres);
        fluid.sweep(member, spheres);
      }
    });
    // The halves of the body force and of what the sphere takes cancel in the mean of the steady state.
    mean = fluid.totals(team).momentum.x / volume;
  }
  team.run([&](Member& member) { fluid.prepare(member, spheres); });
  const double taken = load_on_sphere(fluid.exchange(0), {}, {}).force.x;
  return {force * volume / (6 * pi * viscosity * radius * mean), taken / (force * volume) - 1};
}

TEST(CubicArrayDrag, AnywhereOnTheGrid) {
  for (const Vec3<double>& centre : {Vec3<double>{8.5, 8.5, 8.5}, Vec3<double>{0.2, 15.7, 3.4}}) {
    const Array array = cubic_array(1.0, centre);
    EXPECT_NEAR(array.drag / exact, 1, 0.006);
    EXPECT_NEAR(array.imbalance, 0, 1e-4);
  }
}

TEST(LongCubicArrayDrag, DoesNotDependOnTheRelaxationTime) {
  const double reference = cubic_array(1.0, {8.3, 7.9, 8.1}).drag;
  for (const double tau : {0.6, 2.0}) EXPECT_NEAR(cubic_array(tau, {8.3, 7.9, 8.1}).drag / reference, 1, 0.001);
}

/// Values of an independent program (sub-cells, 10 in each direction).
TEST(LongCubicArrayDrag, PublishedVariants) {
  CouplingSetup coupling;
  coupling.solid = {"sub-cells", "linear", 1};
  EXPECT_NEAR(cubic_array(0.7, {8, 8, 8}, coupling, "BGK").drag / exact, 1.026, 0.002);
  coupling.coupling_operator = "bounce-back";
  EXPECT_NEAR(cubic_array(0.7, {8, 8, 8}, coupling, "BGK").drag / exact, 1.164, 0.002);
  coupling.solid.weight = "noble-torczynski";
  EXPECT_NEAR(cubic_array(0.6, {8, 8, 8}, coupling, "BGK").drag / exact, 0.976, 0.002);
}

}  // namespace
}  // namespace stresslet
