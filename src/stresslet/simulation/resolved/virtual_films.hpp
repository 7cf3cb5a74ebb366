#pragma once
/// What the lubricated model would make of the moment in which a resolved run is: the stress of its films at these
/// positions and velocities, with its own law and cut-offs. A comparison only: no force of the run (Najuch, PhD thesis,
/// University of Edinburgh 2018, section 5.3.2, "virtual" lubrication stress).
#include "stresslet/rheology/stress.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// The parts lubrication_normal ... lubrication_strain of a StressParts, per volume in units of viscosity x shear rate;
/// zero for models without films. `velocity`: synchronous to the positions.
StressParts virtual_film_stress(const Suspension& s, const TwistVector& velocity, ThreadTeam& team);

}  // namespace stresslet
