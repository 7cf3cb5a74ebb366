/// Lattice units: the definitions of the dimensionless groups hold, limits bind, and the nearest possible combinations
/// that messages name are possible, and hardly more than possible.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/simulation/fluid/lattice_units.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;

const double speed_of_sound = 1 / std::sqrt(3.0);

TEST(LatticeUnits, KeepTheDimensionlessGroups) {
  for (const double reynolds : {0.01, 1.0, 30.0, 400.0})
    for (const std::int64_t n : {8, 100}) {
      const LatticeChoice choice{reynolds, n, 2.0, 0.1, {}};
      const LatticeUnits u = lattice_units(choice);
      EXPECT_NEAR(u.velocity * double(n) / u.viscosity() / reynolds, 1, 1e-12);
      EXPECT_NEAR(u.viscosity(), (u.relaxation_time - 0.5) / 3, 1e-15);
      EXPECT_NEAR(u.cell * double(n), 1, 1e-15);
      EXPECT_NEAR(u.step, u.velocity * u.cell, 1e-15);  // dt U / L
      EXPECT_NEAR(u.mach, 2 * u.velocity / speed_of_sound, 1e-12);
      EXPECT_NEAR(u.grid_reynolds, 2 * reynolds / double(n), 1e-9 * reynolds);
    }
}

/// Free of a given relaxation time, the step is as long as one of the two limits allows.
TEST(LatticeUnits, OneOfTheTwoLimitsBinds) {
  const LatticeUnits slow = lattice_units({0.1, 32, 1, 0.1, {}});
  EXPECT_NEAR(slow.relaxation_time, 1, 1e-12);
  EXPECT_LT(slow.mach, 0.1);
  const LatticeUnits fast = lattice_units({300, 32, 1, 0.1, {}});
  EXPECT_NEAR(fast.mach, 0.1, 1e-12);
  EXPECT_LT(fast.relaxation_time, 1);
}

/// Water in a channel of 1 mm at 1 mm/s: Re = 1; 20 cells of 50 um at tau = 0.8, nu_lu = 0.1, U_lu = 0.005, dt = 0.25
/// ms.
TEST(LatticeUnits, OfAKnownExample) {
  const LatticeUnits u = lattice_units({1, 20, 1, 0.1, 0.8});
  EXPECT_NEAR(u.velocity, 0.005, 1e-15);
  EXPECT_NEAR(u.step * 1.0 /* L/U in s */, 0.25e-3, 1e-15);
  EXPECT_NEAR(u.force_density(), 0.005 * 0.005 / 20, 1e-18);
  EXPECT_NEAR(u.rate(), 0.005 / 20, 1e-15);
}

TEST(LatticeUnits, MachNumberAboveTheCapIsImpossible) {
  const LatticeChoice choice{100, 32, 1, 0.1, 1.0};
  const auto why = impossible(choice);
  ASSERT_TRUE(why);
  EXPECT_THAT(why->problem, HasSubstr("Mach number would be 0.902"));  // sqrt(3) (1/6) 100/32
  // Largest relaxation time 0.5 + 3 (0.1/sqrt(3)) 32/100 = 0.55542; least resolution (1/6) 100 sqrt(3)/0.1 = 288.7.
  EXPECT_THAT(why->nearest, HasSubstr("relaxation_time = 0.5554, or domain.resolution = 289"));
  EXPECT_FALSE(impossible({100, 32, 1, 0.1, 0.5554}));
  EXPECT_TRUE(impossible({100, 32, 1, 0.1, 0.5556}));
  EXPECT_FALSE(impossible({100, 289, 1, 0.1, 1.0}));
  EXPECT_TRUE(impossible({100, 288, 1, 0.1, 1.0}));
}

TEST(LatticeUnits, UnreachableReynoldsNumberNamesTheNearest) {
  const LatticeChoice choice{1e5, 32, 1, 0.1, {}};
  const auto why = impossible(choice);
  ASSERT_TRUE(why);
  EXPECT_THAT(why->problem, HasSubstr("Reynolds number 100000 cannot be reached with 32 cells"));
  // nu_lu >= 0.005/3: Re <= (0.1/sqrt(3)) 32 / (0.005/3) = 1108.5; N >= 1e5 (0.005/3) sqrt(3)/0.1 = 2886.8.
  EXPECT_THAT(why->nearest, HasSubstr("Reynolds number 1109 at this resolution, or domain.resolution = 2887"));
  EXPECT_FALSE(impossible({1108, 32, 1, 0.1, {}}));
  EXPECT_FALSE(impossible({1e5, 2887, 1, 0.1, {}}));
  EXPECT_TRUE(impossible({1e5, 2886, 1, 0.1, {}}));
}

}  // namespace
}  // namespace stresslet
