/// The Lees-Edwards boundary for populations: against the periodic run, the Kelvin mode, and its conservation law.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/boundary/interpolation.hpp"
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

CellState wavy(const Cells& c, const Cells& n) {
  const double x = 2 * pi * c[0] / n[0], y = 2 * pi * c[1] / n[1], z = 2 * pi * c[2] / n[2];
  CellState s;
  s.density = 1 + 0.001 * std::sin(x + 2 * y) * std::cos(z);
  s.velocity = {0.02 * std::sin(y + x), 0.01 * std::cos(2 * x - y + z), 0.01 * std::sin(x) * std::cos(y)};
  return s;
}

FluidSetup sheared(const Cells& size) {
  FluidSetup setup;
  setup.grid.size = size;
  setup.grid.closure[1] = Closure::sheared;
  setup.rates.relaxation_time = 0.7;
  return setup;
}

TEST(ShearedFluid, WithoutShearEqualsThePeriodicRunBitForBit) {
  ThreadTeam team(1);
  const Cells n{9, 8, 7};
  FluidSetup setup = sheared(n);
  setup.forcing = "guo";
  const auto with = Fluid::make(setup);
  setup.grid.closure[1] = Closure::periodic;
  const auto without = Fluid::make(setup);
  for (Fluid* fluid : {with.get(), without.get()}) {
    fluid->set_force_density({1e-4, -2e-5, 3e-5});
    fluid->initialise(team, [&](const Cells& c) { return wavy(c, n); });
  }
  for (const int steps : {1, 2, 4}) {
    with->advance(team, steps);
    without->advance(team, steps);
    EXPECT_EQ(with->populations(team), without->populations(team)) << "after " << with->steps() << " steps";
  }
}

/// sum momentum_x + U * (mass crossed upwards) is conserved; the mass in the lower half tells what has crossed.
TEST(ShearedFluid, ConservesMassAndMomentum) {
  ThreadTeam team(1);
  for (const auto& stencil : Stencils::names()) {
    const Cells n{12, 10, stencil == "D2Q9" ? 1 : 6};
    FluidSetup setup = sheared(n);
    setup.stencil = stencil;
    setup.shear_velocity_lu = 0.037;
    const auto fluid = Fluid::make(setup);
    fluid->set_shear_offset(3.4);
    fluid->initialise(team, [&](const Cells& c) { return wavy(c, n); });
    const Fluid::Totals before = fluid->totals(team);
    double crossed = 0;
    // The first moment of mass, sum rho y, changes by sum rho u_y a step, less ny times the mass that has crossed.
    const auto first_moment = [&] {
      std::vector<double> cells;
      cells.resize(std::size_t(n[0] * n[1] * n[2]));
      fluid->measure(team, {0, 0, 0}, {n[0] - 1, n[1] - 1, n[2] - 1}, {1, 1, 1},
                     [&](const Cells& c, const CellState& s) {
                       cells[std::size_t(c[0] + n[0] * (c[1] + n[1] * c[2]))] = s.density - 1;
                     });
      double sum = 0;
      for (std::size_t k = 0; k < cells.size(); ++k) sum += cells[k] * double(int(k) / n[0] % n[1]);
      return sum;
    };
    double moment = first_moment();
    for (int step = 0; step < 60; ++step) {
      const double flow = fluid->totals(team).momentum.y;
      fluid->advance(team, 1);
      const double now = first_moment();
      crossed += (flow - (now - moment)) / n[1];
      moment = now;
      const Fluid::Totals after = fluid->totals(team);
      EXPECT_NEAR(after.mass_deviation, before.mass_deviation, 1e-12) << stencil;
      EXPECT_NEAR(after.momentum.x + setup.shear_velocity_lu * crossed, before.momentum.x, 2e-12 * (step + 1))
          << stencil;
      EXPECT_NEAR(after.momentum.y, before.momentum.y, 1e-12) << stencil;
      EXPECT_NEAR(after.momentum.z, before.momentum.z, 1e-12) << stencil;
    }
    EXPECT_GT(std::abs(crossed), 1e-7);
  }
}

TEST(ShearedFluid, DoesNotDependOnBlocksThreadsOrArrangement) {
  const Cells n{13, 9, 8};
  std::vector<double> expected;
  for (const Cells& blocks : {Cells{1, 1, 1}, Cells{1, 2, 1}, Cells{3, 2, 2}, Cells{2, 1, 3}})
    for (const int threads : {1, 2, 3})
      for (const int first_part : {0, 7, 8}) {
        ThreadTeam team(threads);
        FluidSetup setup = sheared(n);
        setup.grid.blocks = blocks;
        setup.forcing = "guo";
        setup.shear_velocity_lu = 0.03;
        auto fluid = Fluid::make(setup);
        fluid->set_force_density({1e-4, 0, -1e-4});
        fluid->initialise(team, [&](const Cells& c) { return wavy(c, n); });
        fluid->advance(team, first_part);
        if (first_part) {
          const auto populations = fluid->populations(team);
          const double offset = fluid->shear_offset();
          fluid = Fluid::make(setup);
          fluid->set_force_density({1e-4, 0, -1e-4});
          fluid->restore(team, populations, first_part);
          fluid->set_shear_offset(offset);
        }
        fluid->advance(team, 15 - first_part);
        const auto populations = fluid->populations(team);
        if (expected.empty()) expected = populations;
        ASSERT_EQ(populations, expected) << "blocks " << blocks[0] << blocks[1] << blocks[2] << " threads " << threads
                                         << " restart after " << first_part;
      }
}

/// Vorticity w = A cos(k.x), k = (2 pi/L)(1, 1) at first: amplitude and phase of the advected, damped mode (Kelvin,
/// Phil. Mag. 24 (1887) 188) relative to the exact solution, at strain 0.6.
std::complex<double> kelvin_ratio(int length, double relaxation_time, const std::string& interpolation) {
  ThreadTeam team(1);
  FluidSetup setup = sheared({length, length, 1});
  setup.stencil = "D2Q9";
  setup.rates.relaxation_time = relaxation_time;
  setup.shear_interpolation = interpolation;
  const double viscosity = kinematic_viscosity_lu(relaxation_time);
  // The mode loses the factor exp(-2) on the way, at any resolution: slow enough for compressibility not to show.
  const double k = 2 * pi / length, strain = 0.6, lost = 2 * strain - strain * strain + strain * strain * strain / 3;
  const double shear_rate = viscosity * k * k * lost / 2;
  const int steps = int(std::ceil(strain / shear_rate));
  setup.shear_velocity_lu = shear_rate * length;
  const double amplitude = 1e-4;
  const auto fluid = Fluid::make(setup);
  // Stream function psi = -A/k^2 cos(k.x): u = d psi/dy, v = -d psi/dx. u = shear y + mode, y from the middle of the
  // box.
  const auto mode = [&](const Cells& c) {
    const double phase = k * c[0] + k * (c[1] - (length - 1) / 2.0), a = amplitude / (2 * k);
    CellState s;
    s.velocity = {a * std::sin(phase) + shear_rate * (c[1] - (length - 1) / 2.0), -a * std::sin(phase), 0};
    s.strain_rate = {a * k * std::cos(phase), -a * k * std::cos(phase), 0, 0.5 * shear_rate, 0, 0};
    return s;
  };
  fluid->initialise(team, mode);
  fluid->advance(team, steps);
  const double reached = steps * shear_rate, kx = k, ky = k * (1 - reached);
  std::vector<std::complex<double>> rows(std::size_t(length), 0.0);
  fluid->measure(team, {0, 0, 0}, {length - 1, length - 1, 0}, {1, 1, 1}, [&](const Cells& c, const CellState& s) {
    const double y = c[1] - (length - 1) / 2.0, phase = kx * c[0] + ky * y;
    rows[std::size_t(c[1])] += s.velocity.y * std::polar(1.0, -phase);
  });
  std::complex<double> sum = 0;
  for (const auto& row : rows) sum += row;
  // v = -A kx/|k|^2 sin(phase) of amplitude A decays as A itself.
  const double decay =
      std::exp(-viscosity / shear_rate * k * k * (2 * reached - reached * reached + std::pow(reached, 3) / 3));
  const std::complex<double> found = 2.0 * sum / double(length * length);
  const std::complex<double> exact = std::complex<double>(0, 1) * amplitude * kx / (kx * kx + ky * ky) * decay;
  return found / exact;
}

TEST(ShearedFluid, KelvinMode) {
  for (const double tau : {0.65, 1.0}) {
    const auto coarse = kelvin_ratio(32, tau, "cubic"), fine = kelvin_ratio(64, tau, "cubic");
    std::printf("tau %.2f: 32 cells %.4f %+.4f, 64 cells %.4f %+.4f; linear, 32 cells %.4f\n", tau, std::abs(coarse),
                std::arg(coarse), std::abs(fine), std::arg(fine), std::abs(kelvin_ratio(32, tau, "linear")));
    EXPECT_NEAR(std::abs(coarse), 1, 0.012);
    EXPECT_NEAR(std::abs(fine), 1, 0.005);
    EXPECT_NEAR(std::arg(fine), 0, 0.005);
  }
}

}  // namespace
}  // namespace stresslet
