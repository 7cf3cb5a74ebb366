#pragma once
/// What the grid does not resolve of the film between a sphere and a half-way wall: measured without correction against
/// exact values, and the lengths of a sub-grid law that close the difference.
#include <array>
#include <string>
#include <vector>

#include "stresslet/coupling/subgrid/subgrid_resistance.hpp"
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

inline constexpr std::array<const char*, 3> wall_motion_names{"approach", "slide", "turn"};

/// Force over 6 pi eta a U of approach and sliding, torque over 8 pi eta a^3 w of turning.
struct WallMeasurement {
  double radius, gap;  ///< cells
  double shift;        ///< of the centre along the wall, both ways, cells
  std::array<double, 3> measured, exact;
};

/// Gaps a/20 and a/10, the centre above a node and above a corner of cells.
std::vector<WallMeasurement> measure_at_wall(Trial& trial, const ResolvedScheme& scheme, double radius);

/// (measured + correction)/exact - 1 of the three motions.
std::array<double, 3> corrected_errors(const WallMeasurement& measurement, const std::string& law,
                                       const SubgridLengths& lengths, const SubgridRange& range);

/// Each length from one motion, as coupling/calibration/calibrate.hpp does for pairs.
SubgridLengths fit_wall_lengths(const std::vector<WallMeasurement>& measurements, const std::string& law,
                                const SubgridRange& range);

}  // namespace stresslet::validation
