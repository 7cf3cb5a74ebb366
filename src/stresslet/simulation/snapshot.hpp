#pragma once
#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// All particles in ascending order of id, velocities as the last forces left them.
Snapshot make_snapshot(const Suspension& s);

}  // namespace stresslet
