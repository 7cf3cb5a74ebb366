#pragma once
/// What the lattice does not resolve of the films between particles, and particles and walls, as lubrication.
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// Coefficients of all active pairs and walls; zero where no correction is chosen. All threads; ends with a barrier.
void update_subgrid_films(Member& member, Suspension& s);

}  // namespace stresslet
