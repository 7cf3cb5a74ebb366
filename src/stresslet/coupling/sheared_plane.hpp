#pragma once
/// Momentum along x that crosses the sheared plane y = 0 upwards in a step, in the frame half-way between the two
/// sides: the flux of momentum that needs no sum of first moments, and so an independent measure of the shear stress.
///
/// Fluid: populations that came up in the last step less those that came down; their momentum is known behind the
/// plane, where the transformation of lattice/boundary/sheared.hpp has changed it by exactly -+U times their mass.
/// Between half-way walls (lattice/boundary/walls.hpp) the populations that arrived from them say what they gave.
/// Solid: a sphere with cells on the other side gives the fluid there the opposite of the force on these cells.
#include "stresslet/coupling/exchange_sums.hpp"
#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

/// The part of a sphere's exchange with the cells behind the sheared plane.
struct ExchangeAcross {
  std::int32_t sphere;
  int images_up;  ///< -1: the sphere's centre is below the plane, these cells above; +1 the other way
  ExchangeSums sums;
};

/// Of the populations, after prepare_step.
template <class Stencil, class T>
double fluid_momentum_across(const Lattice<Stencil, T>& lattice);

/// Momentum along x that the walls across y gave the fluid in the last step, of the lower less that of the upper, half:
/// what passes upwards. `velocity_difference` of the upper wall and the lower.
template <class Stencil, class T>
double wall_momentum_upwards(const Lattice<Stencil, T>& lattice, double velocity_difference);

/// Of the solid, with the spheres' velocities of the sweep.
double solid_momentum_across(const std::vector<ExchangeAcross>& across, const std::vector<ResolvedSphere>& spheres);

}  // namespace stresslet
