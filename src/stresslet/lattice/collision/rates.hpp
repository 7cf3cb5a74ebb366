#pragma once
/// What the user chooses of a collision, and the rates that follow, all in lattice units.
#include <optional>

namespace stresslet {

/// Kinematic viscosity (tau - 1/2)/3.
struct CollisionInput {
  double relaxation_time = 1;
  double magic_parameter = 3.0 / 16;       ///< TRT and MRT: (tau_even - 1/2)(tau_odd - 1/2)
  std::optional<double> bulk_rate;         ///< MRT: rate of the trace of the stress; the shear rate by default
  std::optional<double> higher_even_rate;  ///< MRT: rate of even moments beyond the stress; the shear rate by default
};

struct RelaxationRates {
  double shear, bulk, higher_even, odd;
};

inline double kinematic_viscosity_lu(double relaxation_time) { return (relaxation_time - 0.5) / 3; }

/// The rate 1/tau_odd that makes (tau_even - 1/2)(tau_odd - 1/2) the magic parameter.
inline double odd_rate(double relaxation_time, double magic_parameter) {
  return 1 / (magic_parameter / (relaxation_time - 0.5) + 0.5);
}

}  // namespace stresslet
