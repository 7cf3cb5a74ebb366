#pragma once
/// The boundaries of a fluid, in the order in which they act: exchange, sheared boundary, walls, solid cells, openings.
/// `lattice`, made for the same setup, must stay where it is as long as they live.
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/step.hpp"

namespace stresslet {

template <class Stencil, class T>
Boundaries<Stencil, T> make_boundaries(const FluidSetup& setup, const Lattice<Stencil, T>& lattice);

}  // namespace stresslet
