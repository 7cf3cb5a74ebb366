#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/rheology/fit.hpp"

namespace stresslet {
namespace {

std::vector<ViscosityPoint> points_on_law(double maximum, double exponent, double relative_error) {
  std::vector<ViscosityPoint> points;
  for (double phi : {0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.55, 0.6}) {
    const double eta = std::pow(1 - phi / maximum, -exponent);
    points.push_back({phi, eta, relative_error * eta});
  }
  return points;
}

TEST(ViscosityFit, ExactPointsGiveTheLawBack) {
  for (double maximum : {0.605, 0.65, 0.74}) {
    for (double exponent : {1.3, 1.7, 2.0, 2.5}) {
      const auto points = points_on_law(maximum, exponent, 0.02);
      const ViscosityFit fit = fit_viscosity(points);
      EXPECT_NEAR(fit.maximum_solid_fraction, maximum, 1e-7);
      EXPECT_NEAR(fit.exponent, exponent, 1e-6);
      EXPECT_LT(fit.chi_squared, 1e-8);
      EXPECT_EQ(fit.degrees_of_freedom, 6);
      EXPECT_NEAR(fit.relative_viscosity(0.35), std::pow(1 - 0.35 / maximum, -exponent), 1e-5);
      const ViscosityFit imposed = fit_viscosity(points, exponent);
      EXPECT_NEAR(imposed.maximum_solid_fraction, maximum, 1e-7);
      EXPECT_EQ(imposed.exponent, exponent);
      EXPECT_EQ(imposed.exponent_error, 0);
      EXPECT_EQ(imposed.degrees_of_freedom, 7);
      EXPECT_LT(imposed.maximum_solid_fraction_error, fit.maximum_solid_fraction_error);
    }
  }
}

TEST(ViscosityFit, ErrorsOfTheParametersAreHonest) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  const int draws = 400;
  const auto exact = points_on_law(0.65, 1.7, 0.02);
  double maximum_squares = 0, exponent_squares = 0, imposed_squares = 0, chi_squared = 0;
  for (int d = 0; d < draws; ++d) {
    auto points = exact;
    for (auto& p : points) p.relative_viscosity += p.error * normal(random);
    const ViscosityFit fit = fit_viscosity(points);
    maximum_squares += std::pow((fit.maximum_solid_fraction - 0.65) / fit.maximum_solid_fraction_error, 2) / draws;
    exponent_squares += std::pow((fit.exponent - 1.7) / fit.exponent_error, 2) / draws;
    chi_squared += fit.chi_squared / draws;
    const ViscosityFit imposed = fit_viscosity(points, 1.7);
    imposed_squares +=
        std::pow((imposed.maximum_solid_fraction - 0.65) / imposed.maximum_solid_fraction_error, 2) / draws;
  }
  for (double squares : {maximum_squares, exponent_squares, imposed_squares}) {
    EXPECT_GT(std::sqrt(squares), 0.88);
    EXPECT_LT(std::sqrt(squares), 1.12);
  }
  EXPECT_NEAR(chi_squared, 6, 0.7);
}

TEST(ViscosityFit, OnePointWithImposedExponentHasAClosedForm) {
  // phi_max = phi / (1 - eta^(-1/n)): eta = 16, n = 2, phi = 0.45 gives 0.6, and d phi_max / d eta by hand.
  const ViscosityFit fit = fit_viscosity(std::vector<ViscosityPoint>{{0.45, 16, 0.1}}, 2.0);
  EXPECT_NEAR(fit.maximum_solid_fraction, 0.6, 1e-8);
  EXPECT_NEAR(fit.maximum_solid_fraction_error, 0.1 * 0.45 * (0.5 * std::pow(16, -1.5)) / (0.75 * 0.75), 1e-8);
  EXPECT_EQ(fit.degrees_of_freedom, 0);
}

TEST(ViscosityFit, RefusesWhatIsNoSetOfViscosities) {
  using Points = std::vector<ViscosityPoint>;
  EXPECT_THROW(fit_viscosity(Points{}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}, {0.5, 13, 0.1}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}, {0.4, 5, 0}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}, {0.0, 5, 0.1}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}, {0.4, 0.9, 0.1}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}, {0.4, std::nan(""), 0.1}}), InputError);
  EXPECT_THROW(fit_viscosity(Points{{0.5, 12, 0.1}}, -1.0), InputError);
  // Dilute points fix the ratio n / phi_max only; with the exponent imposed they do fix phi_max.
  const Points dilute{{0.02, 1.051, 1e-3}, {0.03, 1.078, 1e-3}, {0.05, 1.13, 1e-3}};
  EXPECT_THROW(fit_viscosity(dilute), InputError);
  EXPECT_NO_THROW(fit_viscosity(dilute, 1.7));
  EXPECT_THROW(fit_viscosity(Points{{0.3, 5, 0.1}, {0.45, 4, 0.1}, {0.5, 3, 0.1}}), InputError);
}

}  // namespace
}  // namespace stresslet
