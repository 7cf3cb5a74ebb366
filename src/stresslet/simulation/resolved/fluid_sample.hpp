#pragma once
/// What a sample of a resolved run holds besides stress and dissipation, and what is carried between samples.
#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/series.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// The shear stress, background included, as the flux of momentum through the sheared plane y = 0, of everything that
/// crosses it: fluid, the solid of spheres that reach across, forces between pairs with one sphere on either side, and
/// spheres themselves since the last reset of ResolvedFlow::carried. Between walls, the mean of what they feel of fluid
/// and spheres. Equals the summed stress plus the growth of ResolvedFlow::stored_momentum. After a step; in units of
/// viscosity x shear rate.
double stress_through_plane(const Suspension& s, ThreadTeam& team);

/// After `sample`, of the fluid as that saw it. Begins to count anew what spheres carry across.
FluidSample sample_fluid(Suspension& s, ThreadTeam& team);

/// The count of the present interval between samples, for a restart in its midst.
void add_carried(Checkpoint& checkpoint, const CarriedAcross& carried);
CarriedAcross carried_across(const Checkpoint& checkpoint);

}  // namespace stresslet
