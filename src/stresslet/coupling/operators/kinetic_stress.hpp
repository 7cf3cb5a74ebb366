#pragma once
/// The part of a particle's stresslet that the usual first moment of node forces misses.
///
/// Where an operator lets the stress of a cell relax with the rate (1-B)/tau instead of 1/tau, the cell carries
///   -(1 - (1-B)/(2 tau)) Pi_neq = 2 eta E - B Pi_neq,   Pi_neq = -2 rho cs^2 E tau/(1-B)   (Chapman & Enskog),
/// that is, the Newtonian stress of the fluid's viscosity and -B Pi_neq, which belongs to the particle. Its complete
/// stresslet is  S = sum over cells of sym(F x) - B Pi_neq.  Zero for superposition and guo-form. Tension positive,
/// with trace. Pi_neq = sum f c c - rho u* u* - rho cs^2 I of the incoming populations.
#include "stresslet/lattice/moments.hpp"

namespace stresslet {

/// Pi_neq of one cell; `velocity` is u*.
template <class Populations, class R>
[[gnu::always_inline]] inline SymTensor3<R> non_equilibrium_stress(const Populations& f, const Vec3<R>& velocity) {
  using Stencil = typename Populations::Stencil;
  const Moments<R> m = moments_of(f);
  const R pressure = as<R>(speed_of_sound_squared) * m.density_deviation;
  const SymTensor3<R> isotropic{pressure, pressure, Stencil::dimensions == 3 ? pressure : as<R>(0),
                                as<R>(0), as<R>(0), as<R>(0)};
  return second_moment(f) - isotropic - m.density() * square(velocity);
}

/// Kinetic stress of a cell under `Operator` with solid weight B.
template <class Operator, class R>
[[gnu::always_inline]] inline SymTensor3<R> kinetic_stress(const R& weight, const SymTensor3<R>& non_equilibrium) {
  return as<R>(Operator::kinetic_stress_factor) * weight * non_equilibrium;
}

}  // namespace stresslet
