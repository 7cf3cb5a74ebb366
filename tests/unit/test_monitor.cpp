/// The run-time checks: silent on good numbers, and on bad ones a message that names quantity, place and fix.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "../numerical_failure.hpp"
#include "stresslet/simulation/monitor.hpp"

namespace stresslet {
namespace {

using ::testing::AllOf;
using testing::failure_of;
using ::testing::HasSubstr;

/// Samples every 0.01 of strain up to `strain`: stress 3 from contacts, dissipation as given.
Series series_up_to(double strain, double dissipation) {
  Series series;
  Sample sample;
  sample.stress.contact.xy = 3;
  sample.dissipation_lubrication = dissipation;
  for (int k = 0; 0.01 * k < strain + 1e-9; ++k) series.add(0.01 * k, sample, 10, 1);
  return series;
}

TEST(EnergyBalance, HoldsWithinTheTolerance) {
  for (const double dissipation : {2.7, 3.0, 3.3})  // viscosity 4 against 3.7, 4, 4.3
    EXPECT_NO_THROW(check_energy_balance(series_up_to(0.5, dissipation), 0.08));
  for (const double dissipation : {2.6, 3.4}) {
    const std::string message = failure_of([&] { check_energy_balance(series_up_to(0.5, dissipation), 0.08); });
    EXPECT_THAT(message, AllOf(HasSubstr("relative viscosity 4 from stress"), HasSubstr("between strain 0.3 and 0.5"),
                               HasSubstr("\n  why: "), HasSubstr("\n  fix: ")));
  }
}

TEST(EnergyBalance, WaitsForAWholeWindow) {
  EXPECT_NO_THROW(check_energy_balance(series_up_to(0.19, 30), 0.1));
  EXPECT_THROW(check_energy_balance(series_up_to(0.21, 30), 0.1), NumericalFailure);
}

/// Samples that scatter by 2: by chance the mean of 20 is 0.45 off, and seldom 1.4.
TEST(EnergyBalance, AllowsForTheScatterOfSamples) {
  const auto series_about = [](double dissipation) {
    Series series;
    Sample sample;
    sample.stress.contact.xy = 3;
    for (int k = 0; k <= 50; ++k) {
      sample.dissipation_lubrication = dissipation + (k % 2 ? 2 : -2);
      series.add(0.01 * k, sample, 10, 1);
    }
    return series;
  };
  EXPECT_NO_THROW(check_energy_balance(series_about(3.5), 0.1));
  EXPECT_NO_THROW(check_energy_balance(series_about(4.4), 0.1));
  EXPECT_THROW(check_energy_balance(series_about(5.2), 0.1), NumericalFailure);
  EXPECT_THROW(check_energy_balance(series_about(3.2), 1e-3), NumericalFailure);
}

/// What is stored in springs is not lost: the growth of the energy counts as dissipation does.
TEST(EnergyBalance, CountsStoredEnergy) {
  Series series;
  Sample sample;
  sample.stress.contact.xy = 3;
  sample.dissipation_sliding = 1;
  for (int k = 0; k <= 50; ++k) {
    sample.elastic_energy = 0.02 * k;  // 2 per unit strain
    series.add(0.01 * k, sample, 10, 1);
  }
  EXPECT_NO_THROW(check_energy_balance(series, 0.01));
}

/// Summed viscosity 4, flux as given; momentum that grows by 0.5 a unit of strain stays in the box.
Series series_with_flux(double flux) {
  Series series(FluidColumns::resolved_and_sheared);
  Sample sample;
  sample.stress.contact.xy = 3;
  sample.dissipation_lubrication = 3;
  FluidSample fluid;
  fluid.viscosity_through_plane = flux;
  for (int k = 0; k <= 50; ++k) {
    fluid.stored_momentum = 0.005 * k;
    series.add(0.01 * k, sample, 10, 1, fluid);
  }
  return series;
}

TEST(StressClosure, HoldsWithinTheTolerance) {
  for (const double flux : {4.2, 4.5, 4.9}) EXPECT_NO_THROW(check_stress_closure(series_with_flux(flux), 0.1));
  for (const double flux : {4.0, 5.1}) {
    const std::string message = failure_of([&] { check_stress_closure(series_with_flux(flux), 0.1); });
    EXPECT_THAT(message, AllOf(HasSubstr("4.5 from the sum"), HasSubstr("between strain 0.3 and 0.5"),
                               HasSubstr("\n  why: "), HasSubstr("\n  fix: ")));
  }
}

TEST(StressClosure, IsNotAskedWhereThereIsNoFlux) { EXPECT_NO_THROW(check_stress_closure(series_up_to(0.5, 3), 1e-9)); }

Suspension two_particles() {
  Suspension s;
  s.state.resize(2);
  s.state.id = {7, 4};
  s.strain = 1.25;
  return s;
}

TEST(Finite, EveryComponentOfEveryParticleIsLookedAt) {
  EXPECT_NO_THROW(check_finite(two_particles()));
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity}) {
    const auto message = [bad](AlignedVector<double> ParticleState::*array) {
      Suspension s = two_particles();
      (s.state.*array)[1] = bad;
      return failure_of([&] { check_finite(s); });
    };
    for (auto array : {&ParticleState::x, &ParticleState::y, &ParticleState::z})
      EXPECT_THAT(message(array), AllOf(HasSubstr("particle 4 has position"), HasSubstr("strain 1.25")));
    for (auto array : {&ParticleState::ux, &ParticleState::uy, &ParticleState::uz})
      EXPECT_THAT(message(array), HasSubstr("particle 4 has velocity"));
    for (auto array : {&ParticleState::wx, &ParticleState::wy, &ParticleState::wz})
      EXPECT_THAT(message(array), HasSubstr("particle 4 has angular velocity"));
  }
}

TEST(Solver, MustHaveConverged) {
  Suspension s = two_particles();
  s.solver_report.converged = true;
  EXPECT_NO_THROW(check_solver(s));
  s.solver_report = {};
  s.solver_report.converged = false;
  s.solver_report.iterations = 1000;
  s.solver_report.residual = 0.5;
  EXPECT_THAT(failure_of([&] { check_solver(s); }),
              AllOf(HasSubstr("residual 0.5 after 1000 iterations"), HasSubstr("\n  fix: ")));
}

TEST(ExplicitStep, MayNotReachTheStableOne) {
  EXPECT_NO_THROW(check_explicit_step(1.99, 1e-5));
  const std::string message = failure_of([] { check_explicit_step(4.0, 1e-5); });
  EXPECT_THAT(message, AllOf(HasSubstr("time step 1e-05 exceeds 5e-06"), HasSubstr("time.step below 4e-06")));
}

}  // namespace
}  // namespace stresslet
