#pragma once
/// Stepping with a force that may oscillate.
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

/// The force of the fluid's present time. Measuring needs it too: the velocity counts half the force.
void set_drive(Fluid& fluid, const FluidPlan& plan);

/// Steps the fluid, the force following the time.
void advance(Fluid& fluid, const FluidPlan& plan, ThreadTeam& team, std::int64_t steps);

}  // namespace stresslet
