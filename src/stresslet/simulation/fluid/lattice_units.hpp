#pragma once
/// From dimensionless groups to lattice units: cell size, time step and relaxation time for a resolution and a largest
/// Mach number.
///
/// With Re = U L / nu, N cells in L, and the velocity U_lu that U has in lattice units (cell and time step 1):
///   dx = L / N,   dt = U_lu dx / U,   nu_lu = U_lu N / Re,   tau = 3 nu_lu + 1/2,   Ma = U_lu u_max / U * sqrt(3),
/// u_max the fastest velocity of the flow. One of U_lu and tau is free. Given tau, U_lu = nu_lu Re / N; otherwise the
/// largest U_lu is taken for which tau <= 1 and Ma <= the largest Mach number: accuracy falls with tau above 1 and with
/// Ma^2 (Krueger et al., The Lattice Boltzmann Method (2017), sections 4.4 and 7.2).
#include <cstdint>
#include <optional>
#include <string>

namespace stresslet {

/// What the user fixes; U and L are the units of velocity and length.
struct LatticeChoice {
  double reynolds = 1;
  std::int64_t resolution = 1;
  double fastest_velocity = 1;
  double largest_mach = 0.1;
  std::optional<double> relaxation_time;
};

struct LatticeUnits {
  double cell;      ///< in L
  double step;      ///< in L/U
  double velocity;  ///< U in lattice units
  double relaxation_time;
  double mach;           ///< of the fastest velocity
  double grid_reynolds;  ///< of the fastest velocity and one cell

  double viscosity() const { return (relaxation_time - 0.5) / 3; }
  /// What the units of the program are in lattice units.
  double pressure() const { return velocity * velocity; }
  double force_density() const { return velocity * velocity * cell; }
  double rate() const { return velocity * cell; }
};

/// Relaxation times at which the collision laws are verified.
inline constexpr double lowest_verified_relaxation_time = 0.51, highest_verified_relaxation_time = 3;

LatticeUnits lattice_units(const LatticeChoice& choice);

/// Why a combination cannot be run, and the nearest ones that can.
struct ImpossibleUnits {
  std::string problem, reason, nearest;
};
std::optional<ImpossibleUnits> impossible(const LatticeChoice& choice);

}  // namespace stresslet
