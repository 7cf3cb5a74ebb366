#pragma once
/// What the periodic images of a pair of spheres in a cube of edge L add to the flow at the pair, to order L^-3.
///
/// The periodic Stokeslet (Hasimoto, J. Fluid Mech. 5 (1959) 317) is (delta_ij lap - d_i d_j) b/(8 pi eta), with b a
/// biharmonic function; less that of free space, b = r, it is regular at the origin:
///   b = const - 0.9457656 r^2/L + c1 r^4 + c2 (x^4 + y^4 + z^4 - 3/5 r^4) + ...,
///   c1 = pi/(15 L^3)           from lap lap b = 8 pi/L^3, the counterpressure of the mean force,
///   c2 = -25/48 S/L^3,         S = sum of (x^4+y^4+z^4)/r^4 - 3/5 over r^3, over the unit lattice in spheres,
/// the latter from the Legendre expansion of |r - R|. A net force f sees -2.837297 f/(6 pi eta L). A first moment
/// D_ij = sum f_i x_j of forces on the fluid sees the velocity gradient G_ik = -K_ijkl D_jl, K_ijkl = d_k d_l of the
/// regular part; by the reciprocal theorem its power in the motion with moment D' is  G_ik D'_ik.
#include <Eigen/Dense>

#include "stresslet/base/constants.hpp"

namespace stresslet {

/// S above, summed with a Gaussian of growing width.
inline constexpr double cubic_lattice_sum = 1.8679;

/// Velocity at the pair per net force on the fluid.
inline double net_force_mobility(double dynamic_viscosity, double edge) {
  return -2.837297 / (6 * pi * dynamic_viscosity * edge);
}

/// K_ijkl D_ik D'_jl, what the images take off the power that the fluid receives in motion D' with the forces of D.
inline double image_power(const Eigen::Matrix3d& d, const Eigen::Matrix3d& other, double dynamic_viscosity,
                          double edge) {
  const double volume = edge * edge * edge, c1 = pi / (15 * volume), c2 = -25.0 / 48 * cubic_lattice_sum / volume;
  const double contraction = d.cwiseProduct(other).sum();
  const double exchanged = d.cwiseProduct(other.transpose()).sum();
  const double diagonal = d.diagonal().dot(other.diagonal());
  const double fourth =
      8 * (c1 - 0.6 * c2) * (contraction + exchanged + d.trace() * other.trace()) + 24 * c2 * diagonal;
  return (40 * c1 * contraction - fourth) / (8 * pi * dynamic_viscosity);
}

}  // namespace stresslet
