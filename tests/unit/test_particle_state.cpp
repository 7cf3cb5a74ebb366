// What a particle adds to the momentum of what surrounds it.
#include <gtest/gtest.h>

#include "stresslet/particles/state.hpp"

namespace stresslet {
namespace {

TEST(ParticleState, LeavesTheFluidInsideToTheLattice) {
  ParticleState state;
  state.resize(3);
  for (std::size_t i = 0; i < 3; ++i) state.radius[i] = 1.5;
  state.density = {0.5, 2, 3};
  const double volume = 4.5 * pi;
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(state.own_mass(i), state.mass(i));  // no lattice
  state.fluid_density = 2;
  EXPECT_EQ(state.own_mass(0), 0);  // lighter than the fluid
  EXPECT_EQ(state.own_mass(1), 0);
  EXPECT_NEAR(state.own_mass(2), volume, 1e-13);
  EXPECT_NEAR(state.own_inertia(2), 0.4 * volume * 2.25, 1e-13);
  EXPECT_NEAR(state.mass(2), 3 * volume, 1e-13);
}

}  // namespace
}  // namespace stresslet
