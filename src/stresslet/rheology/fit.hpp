#pragma once
/// Weighted least-squares fit of the viscosity law eta_r = (1 - phi / phi_max)^(-n), the form of Krieger & Dougherty
/// (Trans. Soc. Rheol. 3 (1959) 137) and, with n = 2, of Maron & Pierce.
///
/// The sum of ((law - eta_r) / error)^2 is minimised by Levenberg-Marquardt, started from the best straight line in
/// log eta_r over a scan of phi_max. Errors of the parameters follow from the curvature at the minimum and from the
/// errors of the points as given; chi_squared / degrees_of_freedom well above 1 says that the law or those are wrong.
#include <optional>
#include <span>

namespace stresslet {

struct ViscosityPoint {
  double solid_fraction, relative_viscosity, error;
};

struct ViscosityFit {
  double maximum_solid_fraction, maximum_solid_fraction_error;
  double exponent, exponent_error;  ///< the error of an imposed exponent is 0
  double chi_squared;
  int degrees_of_freedom;

  double relative_viscosity(double solid_fraction) const;
};

/// Fits phi_max and n, or phi_max alone where `exponent` imposes n. Throws InputError where the points are fewer than
/// the parameters, are no viscosities (phi <= 0, eta_r <= 1, error <= 0, not finite), or do not fix the parameters.
ViscosityFit fit_viscosity(std::span<const ViscosityPoint> points, std::optional<double> exponent = std::nullopt);

}  // namespace stresslet
