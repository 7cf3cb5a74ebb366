// What single boundary laws add to the conformance of all: slip, order, stability, flow from opening to opening.
#include <gtest/gtest.h>

#include "../boundary_cases.hpp"

namespace stresslet {
namespace {

using namespace testing;

TEST(HalfWayWall, SlipsAsTheMagicParameterTells) {
  // F/(8 nu) ((16/3) Lambda - 1) at the wall, added to the parabola; BGK has Lambda = (tau - 1/2)^2.
  for (const std::string law : {"half-way", "full-way"})
    for (const std::string collision : {"TRT", "BGK"})
      for (const double tau : {0.6, 0.5 + std::sqrt(3.0) / 4, 2.0}) {
        const int n = 7;
        FluidSetup setup = between_faces({"D3Q19", 3}, 1, law, {1, n, 1});
        setup.rates.relaxation_time = tau, setup.rates.magic_parameter = 1.0 / 12, setup.collision = collision;
        setup.forcing = "guo";
        const double magic = collision == "BGK" ? (tau - 0.5) * (tau - 0.5) : 1.0 / 12;
        SmallFluid fluid(setup);
        const double force = 1e-10, viscosity = kinematic_viscosity_lu(tau);
        fluid->set_force_density({force, 0, 0});
        fluid.start_at_rest();
        fluid.advance(int(300 / viscosity));
        const double slip = force / (8 * viscosity) * (16.0 / 3 * magic - 1);
        fluid.for_each([&](const Cells& c, const CellState& state) {
          const double y = c[1] + 0.5;
          EXPECT_NEAR(state.velocity.x / (force / (2 * viscosity)), y * (n - y) + slip * 2 * viscosity / force, 1e-8)
              << law << collision << tau;
        });
      }
}

/// Peak velocity of flow along x under a body force between regularised resting faces across y, over the closed form.
double regularised_peak(const std::string& stencil, double relaxation_time, int cells) {
  FluidSetup setup = between_faces({stencil, 0}, 1, "regularised-velocity", {1, cells, 1});
  setup.rates.relaxation_time = relaxation_time, setup.forcing = "guo";
  SmallFluid fluid(setup);
  const double force = 1e-10, viscosity = kinematic_viscosity_lu(relaxation_time), half = 0.5 * (cells - 1);
  fluid->set_force_density({force, 0, 0});
  fluid.start_at_rest();
  fluid.advance(int(6 * half * half / viscosity));
  return fluid.at({0, (cells - 1) / 2, 0}).velocity.x / (force * half * half / (2 * viscosity));
}

TEST(RegularisedVelocity, ConvergesToPoiseuilleFlowWithSecondOrder) {
  for (const std::string stencil : {"D2Q9", "D3Q19", "D3Q27"})
    for (const double tau : {0.55, 0.9, 2.0}) {
      const double coarse = regularised_peak(stencil, tau, 9) - 1, fine = regularised_peak(stencil, tau, 17) - 1;
      EXPECT_LT(std::abs(coarse), 0.006) << stencil << tau;
      EXPECT_NEAR(coarse / fine, 4, 0.05) << stencil << tau;
    }
}

TEST(RegularisedFaces, StayStableWithBgkWhereOthersDoNot) {
  for (const bool regularised : {false, true}) {
    const std::string prefix = regularised ? "regularised-" : "";
    FluidSetup setup = between_faces({"D2Q9", 2}, 0, prefix + "velocity", {40, 16, 1});
    setup.faces[0][1].law = prefix + "pressure";
    setup.faces[0][0].velocity_lu = {0.05, 0, 0};
    setup.collision = "BGK", setup.rates.relaxation_time = 0.52;
    SmallFluid fluid(setup);
    fluid.start([](const Cells& c) { return CellState{1, {0.05, 0.001 * std::sin(c[0] * 1.3 + c[1]), 0}, {}}; });
    fluid.advance(3000);
    EXPECT_EQ(fluid.totals().finite, regularised);
  }
}

TEST(Walls, KeepPoiseuilleFlowExactAtFiniteMachNumber) {
  for (const std::string law : {"half-way", "velocity"}) {
    FluidSetup setup = between_faces({"D3Q19", 3}, 1, law, {1, 7, 1});
    setup.rates.relaxation_time = 0.8, setup.forcing = "guo";
    SmallFluid fluid(setup);
    const double half = law == "half-way" ? 3.5 : 3, viscosity = 0.1, peak = 0.1;
    fluid->set_force_density({peak * 2 * viscosity / (half * half), 0, 0});
    fluid.start_at_rest();
    fluid.advance(2000);
    EXPECT_NEAR(fluid.at({0, 3, 0}).velocity.x / peak, 1, 1e-12) << law;
  }
}

/// Peak over mean velocity at the cells of a square duct `n` cells wide (series in White, Viscous Fluid Flow).
double duct_peak_over_mean(int n) {
  const auto velocity = [&](int j, int k) {
    const double y = (j + 0.5) / n - 0.5, z = (k + 0.5) / n - 0.5;
    double sum = 0;
    for (int m = 1; m < 60; m += 2)
      sum += (m % 4 == 1 ? 1 : -1) / std::pow(m, 3) * (1 - std::cosh(m * pi * z) / std::cosh(m * pi / 2)) *
             std::cos(m * pi * y);
    return sum;
  };
  double sum = 0;
  for (int j = 0; j < n; ++j)
    for (int k = 0; k < n; ++k) sum += velocity(j, k);
  return velocity(n / 2, n / 2) * n * n / sum;
}

TEST(Openings, WhatComesInGoesOutOfAChannelAndADuct) {
  for (const std::string prefix : {"", "regularised-"})
    for (const bool duct : {false, true}) {
      const int n = 8, length = 24;
      FluidSetup setup = fluid_setup(duct ? "D3Q19" : "D2Q9", {length, n, duct ? n : 1},
                                     {Closure::open, Closure::open, duct ? Closure::open : Closure::periodic});
      setup.rates.relaxation_time = 0.9;
      setup.faces[0][0].law = prefix + "velocity", setup.faces[0][1].law = prefix + "pressure";
      setup.faces[0][0].velocity_lu = {1e-4, 0, 0};
      SmallFluid fluid(setup);
      fluid.start_at_rest();
      fluid.advance(3000);
      std::vector<double> flux(length);
      double peak = 0, mean = 0;
      fluid.for_each([&](const Cells& c, const CellState& state) {
        flux[std::size_t(c[0])] += state.density * state.velocity.x;
        if (c[0] != length * 3 / 4) return;
        peak = std::max(peak, state.velocity.x);
        mean += state.velocity.x / setup.grid.size[1] / setup.grid.size[2];
      });
      for (const double f : flux) EXPECT_NEAR(f / flux[0], 1, 3e-6) << prefix << duct;
      EXPECT_NEAR(mean, 1e-4, 1e-7);
      // At the cells of a channel 8 cells wide the parabola y (8 - y) has the peak 15.75 and the mean 10.75.
      const double expected = duct ? duct_peak_over_mean(n) : 15.75 / 10.75;
      EXPECT_NEAR(peak / mean / expected, 1, duct ? 2e-3 : 1e-4) << prefix << duct;
    }
}

TEST(Openings, ADuctHasItsPeakOverMean) {
  // 2.0963 in the limit of many cells (White, Viscous Fluid Flow): the reference of the test above.
  EXPECT_NEAR(duct_peak_over_mean(65), 2.0963, 1e-3);
}

}  // namespace
}  // namespace stresslet
