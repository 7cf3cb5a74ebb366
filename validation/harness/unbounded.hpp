#pragma once
/// Spheres in Stokes flow without bounds, or above a single wall at rest across y, computed in a small box: its faces
/// are walls of solid cells that move with the velocity which the spheres and the background make there, to the order
/// of force, torque and stresslet of every sphere. What is left out, the higher moments, decays like (a/R)^4 and more,
/// R the distance of the faces.
///
/// The strengths on the faces are those that a run with 8 cells a diameter measures, or exact ones where given; its own
/// come from Faxen's laws, each sphere in the flow of the others, iterated (method of reflections). An error of the
/// strengths reaches the result multiplied by the effect of the box, some a/R for forces and (a/R)^2 for stresslets.
#include <array>
#include <functional>
#include <optional>

#include "validation/harness/resolved_flow.hpp"
#include "validation/harness/stokes_fields.hpp"

namespace stresslet::validation {

struct UnboundedSphere {
  Vec3<double> centre{};  ///< from the middle of the box, in radii
  Motion motion = Motion::prescribed;
  Vec3<double> velocity{}, angular_velocity{};  ///< prescribed, or where free to move or turn, the first guess
  std::optional<Vec3<double>> force{};          ///< that it gives to the fluid, where known
};

struct Unbounded {
  ResolvedScheme scheme;
  double radius = 5;             ///< in cells
  double clearance = 4;          ///< from the spheres' surfaces to the faces, in radii
  double speed = 1e-3;           ///< lattice units, of the unit velocity (and, over a radius, of the unit rate)
  double shear_rate = 0;         ///< background u = (rate y, 0, 0) about the middle of the box
  SymTensor3<double> strain{};   ///< background u = E x
  std::optional<double> wall{};  ///< its y in radii, below all spheres; the shear is then about it
  Vec3<double> shift{};          ///< of everything, in cells; above a wall not in y
  std::vector<UnboundedSphere> spheres{};
};

/// In units of radius a, unit velocity U and fluid viscosity: force over 6 pi eta a U, torque over 8 pi eta a^2 U,
/// stresslet over (20/3) pi eta a^2 U, of the fluid on the sphere; velocity over U, angular velocity over U/a.
struct UnboundedResult {
  Vec3<double> force, torque, velocity, angular_velocity;
  SymTensor3<double> stresslet;
};

/// Velocity along y through the middle, cell by cell: y over a, u_x over U.
struct VelocityProfile {
  std::vector<double> height, velocity;
};

std::vector<UnboundedResult> run_unbounded(Trial& trial, const Unbounded& setup, const std::string& label,
                                           double tolerance = 5e-4, VelocityProfile* profile = nullptr);

}  // namespace stresslet::validation
