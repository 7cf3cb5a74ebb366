#pragma once
/// Keeping the Verlet list, and everything stored per pair or per particle, in step with the particles.
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// Throws InputError when the box is too small for nearest images to be unique; `where` is the place in the input.
void check_box(const Box& box, double largest_radius, const InteractionRange& range, double skin,
               const std::string& where);

/// Largest distance that a particle has moved against the mean flow since the list was built.
double largest_displacement(const Suspension& s);

/// Builds the list and carries the contact history over. Sorts the particles in space now and then, if `may_sort`:
/// whoever keeps something by the place of a particle meanwhile must not allow it.
void rebuild_neighbours(Suspension& s, ThreadTeam& team, bool may_sort = true);

/// Sizes the work arrays that go with the Verlet list; `rebuild_neighbours` calls it.
void prepare_pair_arrays(Suspension& s);

/// Sizes the work arrays that go with the particles; keeps histories and velocities.
void prepare_particle_arrays(Suspension& s);

}  // namespace stresslet
