#pragma once
/// Monte Carlo moves of hard spheres: each sphere in turn tries a random displacement and keeps it if it then overlaps
/// none. Turns a relaxed packing, whose spheres just touch, into a configuration of the hard-sphere fluid.
#include "stresslet/particles/packing/near_list.hpp"
#include "stresslet/particles/packing/random.hpp"
#include "stresslet/particles/packing/spheres.hpp"

namespace stresslet {

/// Runs `sweeps` sweeps at `inflation`, at which the spheres are free of overlap before and after. The length of the
/// moves is adapted from sweep to sweep so that a third is accepted, up to a limit that dilute systems reach.
void agitate(Spheres& spheres, double inflation, int sweeps, Random& random);

}  // namespace stresslet
