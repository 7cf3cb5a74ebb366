#include "stresslet/simulation/fluid/drive.hpp"

namespace stresslet {

void set_drive(Fluid& fluid, const FluidPlan& plan) { fluid.set_force_density(plan.force_lu(fluid.steps())); }

void advance(Fluid& fluid, const FluidPlan& plan, ThreadTeam& team, std::int64_t steps) {
  if (plan.angular_frequency == 0) {
    fluid.advance(team, int(steps));
    return;
  }
  for (std::int64_t k = 0; k < steps; ++k) {
    fluid.advance(team, 1);
    set_drive(fluid, plan);
  }
}

}  // namespace stresslet
