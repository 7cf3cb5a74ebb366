#pragma once
/// One time step of a suspension:
///   drift            x += U dt, images wrapped, sheared box advanced
///   neighbours       Verlet list rebuilt when a pair could be missing
///   active pairs     separations, gaps
///   contacts         springs advanced with the velocities of the drift
///   resistances      X, Y, B, C of every film
///   velocities       by the time scheme (schemes/laws.hpp)
/// With a resolved fluid the particles may need shorter steps than the lattice. The fluid is measured at the first of
/// `substeps`, drags with these sums through all of them, being linear in the velocities, and is then moved on with the
/// means of the velocities: the impulses that it gives and takes are the same.
/// `start` does the last four at time zero, so that between steps positions, forces and velocities belong together.
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/rheology/stress.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// Allocates the work arrays, finds the neighbours and computes the first velocities.
void start(Suspension& s, ThreadTeam& team);

void step(Suspension& s, ThreadTeam& team);

/// Work arrays and velocities for a suspension whose state, list and history have been read from a checkpoint.
void resume(Suspension& s);

/// Twists that belong to the present positions, where the time scheme keeps them for another moment.
TwistVector synchronous_velocities(const Suspension& s);

/// Stress and energies now, with velocities synchronous to the positions.
Sample sample(const Suspension& s, ThreadTeam& team);

}  // namespace stresslet
