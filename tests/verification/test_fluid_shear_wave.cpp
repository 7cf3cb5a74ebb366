/// Decay of a shear wave u_x = U sin(k y): amplitude exp(-nu k^2 t), at any division into blocks and for every
/// collision law.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

class ShearWave : public ::testing::TestWithParam<std::string> {};

TEST_P(ShearWave, DecaysWithTheViscosity) {
  FluidSetup setup;
  setup.collision = GetParam();
  setup.grid.size = {3, 64, 3};
  setup.grid.blocks = {1, 2, 1};
  setup.rates.relaxation_time = 0.8;
  const double k = 2 * pi / 64, viscosity = kinematic_viscosity_lu(0.8), speed = 1e-3;
  ThreadTeam team(1);
  const auto fluid = Fluid::make(setup);
  fluid->initialise(team, [&](const Cells& c) {
    CellState s;
    s.velocity.x = speed * std::sin(k * c[1]);
    s.strain_rate.xy = 0.5 * speed * k * std::cos(k * c[1]);
    return s;
  });
  const int steps = 201;
  fluid->advance(team, steps);
  double amplitude = 0;
  fluid->measure(team, {1, 0, 1}, {1, 63, 1}, {1, 1, 1},
                 [&](const Cells& c, const CellState& s) { amplitude += s.velocity.x * std::sin(k * c[1]) / 32; });
  const double measured = -std::log(amplitude / speed) / (k * k * steps);
  EXPECT_NEAR(measured / viscosity, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(Collisions, ShearWave, ::testing::ValuesIn(CollisionLaws::names()));

TEST(Couette, LinearBetweenMovingWalls) {
  FluidSetup setup;
  setup.grid.size = {4, 11, 4};
  setup.grid.closure[1] = Closure::open;
  setup.grid.blocks = {2, 1, 1};
  setup.faces[1][0].velocity_lu = {-0.01, 0, 0};
  setup.faces[1][1].velocity_lu = {0.01, 0, 0};
  ThreadTeam team(1);
  const auto fluid = Fluid::make(setup);
  fluid->initialise(team, [](const Cells&) { return CellState{}; });
  fluid->advance(team, 4001);
  fluid->measure(team, {0, 0, 0}, {3, 10, 3}, {1, 1, 1}, [&](const Cells& c, const CellState& s) {
    EXPECT_NEAR(s.velocity.x, 0.02 * (c[1] + 0.5) / 11 - 0.01, 1e-10);
    EXPECT_NEAR(s.strain_rate.xy, 0.01 / 11, 1e-10);
  });
}

}  // namespace
}  // namespace stresslet
