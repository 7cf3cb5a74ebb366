/// The energy that the lattice loses in a step is what its collisions and the slip at the solid are said to dissipate,
/// less what the spheres put in: sum f^2/(6 w), kept by streaming, against the sums of coupling/fluid_energy.hpp, for
/// every collision with every operator. Velocities so small that terms of second order are lost in the tolerance.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

constexpr double speed = 1e-6;

double lattice_energy(const std::vector<double>& populations) {
  const std::size_t cells = populations.size() / D3Q19::size;
  double sum = 0;
  for (std::size_t i = 0; i < std::size_t(D3Q19::size); ++i)
    for (std::size_t c = 0; c < cells; ++c) {
      const double f = populations[i * cells + c];
      sum += f * f / (6 * D3Q19::weight[i]);
    }
  return sum;
}

/// Two spheres in the same cells, at different velocities, in a fluid that is moving.
void expect_balance(const std::string& collision, const std::string& coupling_operator, const char* weight) {
  SCOPED_TRACE(collision + ", " + coupling_operator);
  FluidSetup setup;
  setup.grid.size = {21, 12, 13};
  setup.collision = collision;
  setup.rates.relaxation_time = 0.8;
  setup.rates.magic_parameter = 1.0 / 12;
  CouplingSetup coupling;
  coupling.coupling_operator = coupling_operator;
  coupling.solid.weight = weight;
  ResolvedFluidOf<double> fluid(setup, coupling);
  ThreadTeam team(1);
  fluid.initialise(team, [](const Cells& c) {
    CellState s;
    s.density = 1 + speed * std::sin(0.6 * c[0]);
    s.velocity = {speed * std::sin(0.5 * c[1]), speed * std::cos(0.9 * c[2]), speed * std::sin(0.3 * c[0])};
    return s;
  });
  const std::vector<ResolvedSphere> spheres{{{4.2, 6.1, 6.7}, 3.3, {speed, 0, -speed}, {0, 0.2 * speed, 0.3 * speed}},
                                            {{9.6, 6.4, 7.5}, 2.8, {0, -0.5 * speed, speed}, {0.1 * speed, 0, 0}}};
  std::vector<FreeFluid> planes;
  for (int n = 0; n < 6; ++n) {
    const double before = lattice_energy(fluid.populations(team));
    const FluidEnergy energy = fluid.energy(team, spheres, planes);
    team.run([&](Member& member) {
      fluid.prepare(member, spheres);
      fluid.sweep(member, spheres);
    });
    double power = 0;
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const auto load = load_on_sphere(fluid.exchange(k), spheres[k].velocity, spheres[k].angular_velocity);
      power -= dot(load.force, spheres[k].velocity) + dot(load.torque, spheres[k].angular_velocity);
    }
    const double lost = before - lattice_energy(fluid.populations(team));
    EXPECT_NEAR((lost + power) / (energy.collisions + energy.slip), 1, 1e-5) << n;
    EXPECT_GT(energy.slip, 0);
    EXPECT_GT(energy.collisions, 0);
  }
  EXPECT_GT(fluid.friction().size(), 0u) << "no cells are shared";
}

TEST(FluidEnergy, IsLostWhereItIsSaidToBe) {
  CollisionLaws::for_each([](auto collision) {
    CouplingOperators::for_each([&](auto law) {
      using Operator = typename decltype(law)::type;
      const char* weight = Operator::largest_weight > 1 ? "viscosity-scaled" : "linear";
      expect_balance(std::string(decltype(collision)::type::name), std::string(Operator::name), weight);
    });
  });
}

/// A decaying shear wave, u = A sin(k.x) across k, carried past the lattice with a velocity whose cell Reynolds number
/// is 2.5: it dissipates rho nu (k A)^2/2 a cell, A = exp(-nu k^2 t), whatever the velocity.
void expect_same_dissipation_in_motion(const std::string& collision, const Vec3<double>& motion) {
  SCOPED_TRACE(collision);
  SCOPED_TRACE(motion.x);
  SCOPED_TRACE(motion.y);
  constexpr double amplitude = 1e-3, tau = 0.53, nu = (tau - 0.5) / 3;
  constexpr int length = 48, steps = 60;
  const double k = 2 * pi / length;
  FluidSetup setup;
  setup.grid.size = {length, length, 8};
  setup.collision = collision;
  setup.rates.relaxation_time = tau;
  setup.rates.magic_parameter = 1.0 / 12;
  ResolvedFluidOf<double> fluid(setup, CouplingSetup{});
  ThreadTeam team(1);
  // Along the diagonal of x and y, so that no gradient lies along an axis.
  fluid.initialise(team, [&](const Cells& c) {
    const double phase = k * (c[0] + c[1]);
    CellState s;
    s.velocity = motion + Vec3<double>{0, 0, amplitude * std::sin(phase)};
    s.strain_rate.xz = s.strain_rate.yz = 0.5 * amplitude * k * std::cos(phase);
    return s;
  });
  for (int n = 0; n < steps; ++n)
    team.run([&](Member& member) {
      fluid.prepare(member, {});
      fluid.sweep(member, {});
    });
  std::vector<FreeFluid> planes;
  const double cells = double(length) * length * 8, square = 2 * k * k;
  const double decayed = amplitude * std::exp(-nu * square * steps), expected = 0.5 * nu * square * decayed * decayed;
  EXPECT_NEAR(fluid.energy(team, {}, planes).collisions / (cells * expected), 1, 0.005);
}

TEST(FluidEnergy, IsTheSameInMotion) {
  for (const char* collision : {"TRT", "MRT"})
    for (const Vec3<double>& motion : {Vec3<double>{0, 0, 0}, {0.025, 0, 0}, {0, -0.025, 0}, {0.015, 0.015, 0.01}})
      expect_same_dissipation_in_motion(collision, motion);
}

}  // namespace
}  // namespace stresslet
