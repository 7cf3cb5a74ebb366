#pragma once
/// Suspensions to be timed: 1 : 1.4 spheres by equal volumes at solid fraction 0.5, frictionless CLM-S with the numbers
/// of examples/shear-lubricated, sheared a little so that contacts and films are those of a flow.
#include "stresslet/simulation/suspension.hpp"

namespace stresslet::benchmarks {

/// The suspension of this size, packed and sheared by the semi-implicit scheme on first use and then kept: to strain
/// 0.2 up to 20 000 particles, 0.005 above.
const Suspension& prepared(std::size_t particles);

/// A copy that takes its steps by `scheme` with that scheme's default step, started.
Suspension prepared_for(std::size_t particles, const std::string& scheme, ThreadTeam& team);

}  // namespace stresslet::benchmarks
