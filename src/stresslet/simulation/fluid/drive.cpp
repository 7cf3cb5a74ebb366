#include "stresslet/simulation/fluid/drive.hpp"

#include <cmath>

namespace stresslet {

void set_drive(Fluid& fluid, const FluidPlan& plan) {
  fluid.set_force_density(plan.force_lu(fluid.steps()));
  if (plan.setup.grid.closure[1] == Closure::sheared)
    fluid.set_shear_offset(
        std::fmod(plan.setup.shear_velocity_lu * double(fluid.steps()), double(plan.setup.grid.size[0])));
}

void advance(Fluid& fluid, const FluidPlan& plan, ThreadTeam& team, std::int64_t steps) {
  const bool steady = plan.angular_frequency == 0 && plan.setup.grid.closure[1] != Closure::sheared;
  if (steady) {
    fluid.advance(team, int(steps));
    return;
  }
  for (std::int64_t k = 0; k < steps; ++k) {
    fluid.advance(team, 1);
    set_drive(fluid, plan);
  }
}

}  // namespace stresslet
