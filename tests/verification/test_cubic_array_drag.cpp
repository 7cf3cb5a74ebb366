/// Drag of a simple cubic array of fixed spheres against Zick & Homsy, J. Fluid Mech. 115 (1982) 13 (recomputed
/// digits): K = F / (6 pi mu a U), U the mean velocity over the whole cell, F the force with its mean pressure
/// gradient.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {
namespace {

struct Drag {
  double coefficient, imbalance;
};

Drag cubic_array(double relaxation_time, const Vec3<double>& centre, const CouplingSetup& coupling,
                 const std::string& collision, double magic_parameter) {
  constexpr int edge = 16;
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.collision = collision;
  setup.rates.relaxation_time = relaxation_time;
  setup.rates.magic_parameter = magic_parameter;
  ResolvedFluid fluid(setup, coupling);
  const double force = 1e-6 * kinematic_viscosity_lu(relaxation_time);
  fluid.lattice().input.force_density = {force, 0, 0};
  fluid.fill([](const Cells&) { return CellState{}; });
  const std::vector<ResolvedSphere> spheres{{centre, 5, {}, {}}};
  ThreadTeam team(1);
  double before = 0, after = 1;
  Drag drag{};
  const double volume = double(edge) * edge * edge;
  for (int block = 0; std::abs(after - before) > 1e-7 * std::abs(after) && block < 400; ++block) {
    before = after;
    team.run([&](Member& member) {
      for (int n = 0; n < 50; ++n) {
        fluid.prepare(member, spheres);
        fluid.sweep(member, spheres);
      }
    });
    // Velocity with half of the body force and half of what the sphere takes, which balance in the steady state.
    after = fluid.totals().momentum.x / volume;
  }
  team.run([&](Member& member) { fluid.prepare(member, spheres); });
  const double taken = load_on_sphere(fluid.exchange(0), {}, {}).force.x;
  drag.coefficient = force * volume / (6 * pi * kinematic_viscosity_lu(relaxation_time) * 5 * after);
  drag.imbalance = taken / (force * volume) - 1;
  return drag;
}

constexpr double exact = 4.36973;  // at 4 pi (5/16)^3 / 3: the table between d/L = 0.6 and 0.7, interpolated (1e-5)

TEST(CubicArrayDrag, PrintsForNow) {
  for (const double tau : {0.55, 0.7, 1.0, 2.0})
    for (const Vec3<double>& centre :
         {Vec3<double>{8, 8, 8}, Vec3<double>{8.5, 8.5, 8.5}, Vec3<double>{8.3, 7.9, 8.1}}) {
      const Drag drag = cubic_array(tau, centre, {}, "TRT", 1.0 / 12);
      std::printf("tau %.2f  K/K_ref %.4f  balance %.1e\n", tau, drag.coefficient / exact, drag.imbalance);
    }
  CouplingSetup thesis;
  thesis.solid.weight = "linear";
  std::printf("thesis BGK linear 0.7: %.4f (expected 1.026)\n",
              cubic_array(0.7, {8, 8, 8}, thesis, "BGK", 1).coefficient / exact);
}

}  // namespace
}  // namespace stresslet
