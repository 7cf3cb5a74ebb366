#pragma once
/// The fluid of a case, made and filled.
#include <memory>

#include "stresslet/lattice/fluid.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

/// The set-up with the solid cells added.
FluidSetup complete_setup(const FluidCase& settled, const FluidPlan& plan);

/// A fluid of this set-up. Throws InputError where the combination of laws is not built.
std::unique_ptr<Fluid> make_fluid(const FluidCase& settled, const FluidSetup& setup);

/// Fills it with the flow that [initial] names, at time 0 with the force of that time.
void fill(Fluid& fluid, const FluidCase& settled, const FluidPlan& plan, ThreadTeam& team);

}  // namespace stresslet
