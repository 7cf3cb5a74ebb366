#pragma once
/// Stability of explicit lubrication for the present network of films.
///
/// The velocities obey dU/dt = -M^-1 R U + ...; one explicit step multiplies the fastest mode by 1 - dt lambda_max,
/// with lambda_max the largest eigenvalue of M^-1 R. A particle with several thin films relaxes faster than any pair of
/// them, so the bound from pairs alone (time_step.hpp) can fail in dense packings; this one cannot.
#include "stresslet/simulation/suspension.hpp"

namespace stresslet {

/// dt lambda_max by power iteration from a random start (relative accuracy some per cent, from below). Stable below 2.
/// Overwrites the work vectors `residual` and the wrenches of the lubrication.
double explicit_step_number(Suspension& s, ThreadTeam& team);

}  // namespace stresslet
