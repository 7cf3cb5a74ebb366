#pragma once
/// The cells of a fluid case that are solid: those whose centres lie in one of its bodies. Bodies that cross a periodic
/// face go on at the other side.
#include <cstdint>
#include <vector>

#include "stresslet/lattice/grid.hpp"
#include "stresslet/simulation/fluid/case.hpp"

namespace stresslet {

/// One byte a cell, x fastest, 1 = solid; empty where the case has no [solid].
/// Throws InputError where voxels do not fit the grid, or where no cell is left to the fluid.
std::vector<std::uint8_t> solid_mask(const FluidCase& settled, const Grid& grid);

}  // namespace stresslet
