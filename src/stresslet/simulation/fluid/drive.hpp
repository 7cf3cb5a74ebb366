#pragma once
/// What changes with time from outside: an oscillating force and the displacement of the sheared image.
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

/// Force and displacement of the fluid's present time. Measuring needs them too: the velocity counts half the force.
void set_drive(Fluid& fluid, const FluidPlan& plan);

/// Steps the fluid, the drive following the time.
void advance(Fluid& fluid, const FluidPlan& plan, ThreadTeam& team, std::int64_t steps);

}  // namespace stresslet
