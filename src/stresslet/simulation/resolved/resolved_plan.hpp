#pragma once
/// The lattice that a case comes to, and what is refused before the run.
#include "stresslet/particles/box.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"

namespace stresslet {

/// Whole numbers of cells along a box of these proportions.
Cells cells_along(const Vec3<double>& box_length, double cells_per_diameter);

/// Throws InputError where the box is no whole number of cells, a particle too small, or the flow too fast.
ResolvedSetup resolved_setup(const Case& settled, const Box& box, double smallest_radius);

/// Memory of the populations.
double resolved_bytes(const ResolvedSetup& setup);

/// The lattice's numbers for people, and warnings.
std::string resolved_lines(const Case& settled, const ResolvedSetup& setup);
std::vector<std::string> resolved_warnings(const Case& settled, const ResolvedSetup& setup, double smallest_radius);

}  // namespace stresslet
