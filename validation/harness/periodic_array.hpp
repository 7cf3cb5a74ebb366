#pragma once
/// Simple cubic arrays of spheres: one sphere in a periodic cube of `edge` cells.
#include "validation/harness/resolved_flow.hpp"

namespace stresslet::validation {

/// K = F/(6 pi eta a U) of fixed spheres in a fluid driven by a uniform force: F the force a sphere takes, with its
/// part of the mean pressure gradient, U the mean velocity over the whole cell. Both are measured, once steady.
double drag_of_cubic_array(Trial& trial, const ResolvedScheme& scheme, int edge, double radius,
                           const Vec3<double>& centre);

struct ArrayRheology {
  double viscosity;                            ///< over the fluid's
  double first_difference, second_difference;  ///< N1, N2 over eta gdot
  double spin;                                 ///< angular velocity about z over gdot
};

/// Free spheres in simple shear across y, at frozen strain: the images above are displaced by `strain` edges.
ArrayRheology sheared_cubic_lattice(Trial& trial, const ResolvedScheme& scheme, int edge, double radius, double strain,
                                    const Vec3<double>& centre);

}  // namespace stresslet::validation
