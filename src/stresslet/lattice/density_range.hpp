#pragma once
/// Whether the fluid is sound: the extremes of its density, and the cell to name where it is not.
#include <algorithm>
#include <cmath>

#include "stresslet/lattice/layout.hpp"

namespace stresslet {

struct DensityRange {
  double lowest_density = 1, highest_density = 1;
  Cells worst_cell{};  ///< where the density is farthest from 1, or the first that is not finite
  bool finite = true;

  /// The density farthest from 1.
  double worst_density() const { return highest_density - 1 > 1 - lowest_density ? highest_density : lowest_density; }

  /// Cells, or ranges of cells, one after the other. `is_finite`: whether density and velocity are.
  void see(const Cells& cell, double density, bool is_finite) { see({density, density, cell, is_finite}); }
  void see(const DensityRange& later) {
    const bool worse = std::abs(later.worst_density() - 1) > std::abs(worst_density() - 1);
    if (finite && (!later.finite || worse)) worst_cell = later.worst_cell;
    finite = finite && later.finite;
    lowest_density = std::min(lowest_density, later.lowest_density);
    highest_density = std::max(highest_density, later.highest_density);
  }
};

}  // namespace stresslet
