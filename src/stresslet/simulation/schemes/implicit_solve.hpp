#pragma once
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// New velocities from (inverse_step M + R + D) V = inverse_step M V_old + forces that do not depend on V. On entry
/// `velocity` holds V_old and `change` the change over the step before, from which the first guess is extrapolated; on
/// exit `velocity` and the state hold V. `inverse_step` = 0 drops inertia. All threads; ends with a barrier.
void implicit_solve(Member& member, Suspension& s, double inverse_step);

}  // namespace stresslet
