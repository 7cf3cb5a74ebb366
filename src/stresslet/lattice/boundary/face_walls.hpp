#pragma once
/// Which wall, opening or solid cell a link meets, and lists of the places concerned.
#include <vector>

#include "stresslet/lattice/boundary/opening_boundary.hpp"
#include "stresslet/lattice/boundary/wall_cells.hpp"
#include "stresslet/lattice/fluid.hpp"

namespace stresslet {

/// Throws std::invalid_argument where faces or solid cells contradict each other.
void check_boundaries(const FluidSetup& setup, int dimensions);

/// The wall met by a link that crosses the faces `crossed` (components -1, 0, 1): the first in the order x, y, z; null
/// where it crosses openings only, or no open face.
const FaceSetup* wall_across(const FluidSetup& setup, const Cells& crossed);

/// Whether the cell, in global coordinates, is solid.
bool is_solid(const FluidSetup& setup, const Cells& cell);

/// Whether a link meets a solid cell: `target` is the cell it leads to, across the periodic faces among `crossed`. Over
/// a wall it meets the solid cell that it would reach by going along the wall, so that a moving wall keeps mass beside
/// solid cells as it does in corners.
bool meets_solid(const FluidSetup& setup, const Cells& crossed, const Cells& target);

/// The fluid cells of the last layer before a face, `side` -1 or 1.
std::vector<CellAt> cells_before(const FluidSetup& setup, int axis, int side, const std::vector<BlockLayout>& layouts);

/// Solid cells, in runs along x.
std::vector<SolidRun> solid_runs(const FluidSetup& setup, const std::vector<BlockLayout>& layouts);

/// Calls `visit(block, cell in block coordinates, global cell)` for every cell of the domain in global order, x
/// fastest.
template <class Visit>
void for_each_cell_in_order(const Grid& grid, Visit&& visit) {
  const std::vector<BlockBox> boxes = block_boxes(grid);
  const Cells& n = grid.blocks;
  // Blocks along a row follow each other in x, and rows of blocks share their y and z.
  for (int bz = 0; bz < n[2]; ++bz)
    for (int z = 0; z < boxes[std::size_t(n[0] * n[1] * bz)].size[2]; ++z)
      for (int by = 0; by < n[1]; ++by)
        for (int y = 0; y < boxes[std::size_t(n[0] * (by + n[1] * bz))].size[1]; ++y)
          for (int bx = 0; bx < n[0]; ++bx) {
            const int b = bx + n[0] * (by + n[1] * bz);
            const BlockBox& box = boxes[std::size_t(b)];
            for (int x = 0; x < box.size[0]; ++x)
              visit(b, Cells{x, y, z}, Cells{box.origin[0] + x, box.origin[1] + y, box.origin[2] + z});
          }
}

/// The links of fluid cells for which `correction_of(global cell, j, faces crossed, global target)` gives a correction.
template <class Stencil, class CorrectionOf>
std::vector<WallLink> wall_links(const FluidSetup& setup, const std::vector<BlockLayout>& layouts,
                                 CorrectionOf&& correction_of) {
  std::vector<WallLink> links;
  for_each_cell_in_order(setup.grid, [&](int block, const Cells& cell, const Cells& global) {
    if (is_solid(setup, global)) return;
    const BlockLayout& layout = layouts[std::size_t(block)];
    for (int j = 1; j < Stencil::size; ++j) {
      Cells crossed{}, target = global;
      for (std::size_t a = 0; a < 3; ++a) {
        const int size = setup.grid.size[a];
        target[a] += Stencil::velocity[j][a];
        if (target[a] < 0) crossed[a] = -1;
        if (target[a] >= size) crossed[a] = 1;
        target[a] -= crossed[a] * size;
      }
      if (const auto correction = correction_of(j, crossed, target)) {
        const std::size_t at = layout.index(cell);
        links.push_back({block, j, at, at + std::size_t(layout.offset(Stencil::velocity[j])), *correction});
      }
    }
  });
  return links;
}

}  // namespace stresslet
