#pragma once
/// One sphere in the middle of a shear flow between moving walls across y, periodic in x and z: the set-up of the
/// thesis's chapter on single spheres. Everything is given over the sphere's exact values in unbounded Stokes flow:
/// stresslet by S0 = (10/3) pi eta a^3 gdot, torque by S0 as well (exact: 1.2), angular velocity by gdot (exact: 1/2).
#include "validation/harness/resolved_flow.hpp"

namespace stresslet::validation {

struct ShearCell {
  ResolvedScheme scheme;
  int cells_per_diameter = 10;
  Vec3<double> box{5, 5, 5};  ///< in diameters; y from wall to wall
  bool fixed = false;         ///< or free to turn
  Vec3<double> shift{};       ///< of the centre from a node, in cells
  std::string walls = "velocity";
  double reynolds_number = 0.05;  ///< gdot d^2 / nu

  double shear_rate() const { return reynolds_number * scheme.viscosity() / (cells_per_diameter * cells_per_diameter); }
  double radius() const { return 0.5 * cells_per_diameter; }
};

struct ShearResult {
  double stresslet, kinetic;  ///< usual first moment; what the complete stresslet has besides
  double torque, spin;        ///< positive along the vorticity
  MomentParts parts;          ///< over S0
  double wall;                ///< what the walls feel above the fluid's own stress, times the volume, over S0
  std::vector<double> height, velocity;  ///< along y through the centre: y/a, u_x/(gdot a)

  /// What the walls should feel: the complete stresslet and half the torque.
  double expected_wall() const { return stresslet + kinetic + 0.5 * torque; }
};

/// Steady to `tolerance` per 2 a^2/nu, or after so many of these times where `times` is given.
ShearResult run_shear_cell(Trial& trial, const ShearCell& cell, const std::string& label, double tolerance = 1e-4,
                           double times = 0);

}  // namespace stresslet::validation
