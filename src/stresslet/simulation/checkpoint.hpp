#pragma once
/// Restart state of a suspension: everything that the next step reads and cannot recompute bit for bit.
#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

Checkpoint make_checkpoint(Suspension& s);

/// Fills the state, the neighbour list and the histories of a suspension whose physics and time control are set.
/// Throws InputError when an array is missing or has the wrong length.
void restore_checkpoint(Suspension& s, const Checkpoint& checkpoint);

}  // namespace stresslet
