#pragma once
/// The whole domain in cells, how its faces close, and its division into blocks.
#include <array>
#include <string>
#include <vector>

#include "stresslet/lattice/layout.hpp"

namespace stresslet {

/// How the two faces across one axis close.
enum class Closure {
  periodic,
  sheared,  ///< Lees-Edwards: periodic with a moving image; y only
  open      ///< boundary laws on both faces
};

struct Grid {
  Cells size{1, 1, 1};
  std::array<Closure, 3> closure{};  ///< periodic by default
  Cells blocks{1, 1, 1};             ///< number of blocks along each axis
};

struct BlockBox {
  Cells origin, size;
};

/// Along x blocks begin at multiples of this where that leaves every block a cell, so that SIMD packs, and sums along a
/// row, hold the same cells whatever the division. Coarser in longer rows: fewer sums.
inline constexpr int grain_in_x(int cells) { return cells < 64 ? 16 : cells < 128 ? 32 : 64; }

/// The blocks of a grid, x fastest, as equal in size as the grain allows.
inline std::vector<BlockBox> block_boxes(const Grid& grid) {
  const auto start = [&](int axis, int k) {
    const int n = grid.size[axis], blocks = grid.blocks[axis];
    const int grain = axis == 0 && n > grain_in_x(n) * (blocks - 1) ? grain_in_x(n) : 1;
    const int grains = (n + grain - 1) / grain;
    return k == blocks ? n : grain * int(std::int64_t(grains) * k / blocks);
  };
  std::vector<BlockBox> boxes;
  for (int bz = 0; bz < grid.blocks[2]; ++bz)
    for (int by = 0; by < grid.blocks[1]; ++by)
      for (int bx = 0; bx < grid.blocks[0]; ++bx) {
        const Cells b{bx, by, bz};
        BlockBox box;
        for (int a = 0; a < 3; ++a) {
          box.origin[a] = start(a, b[a]);
          box.size[a] = start(a, b[a] + 1) - box.origin[a];
        }
        boxes.push_back(box);
      }
  return boxes;
}

/// Where a neighbouring region of a block lies.
struct Neighbour {
  enum class Kind { block, sheared, open } kind;
  int block = -1;       ///< the block that owns the region, where kind is block
  Cells wrap{0, 0, 0};  ///< number of domain lengths to subtract from a global coordinate to reach it
};

/// The region of `block` in direction `d` (components -1, 0, 1). Open faces go before sheared ones.
inline Neighbour neighbour_of(const Grid& grid, int block, const Cells& d) {
  const Cells b{block % grid.blocks[0], block / grid.blocks[0] % grid.blocks[1],
                block / (grid.blocks[0] * grid.blocks[1])};
  Neighbour found{Neighbour::Kind::block, 0, {0, 0, 0}};
  Cells owner;
  for (int a = 0; a < 3; ++a) {
    const int n = grid.blocks[a], k = b[a] + d[a];
    const bool crosses = k < 0 || k >= n;
    owner[a] = (k + n) % n;
    if (!crosses) continue;
    found.wrap[a] = d[a];
    if (grid.closure[a] == Closure::open) found.kind = Neighbour::Kind::open;
    if (grid.closure[a] == Closure::sheared && found.kind != Neighbour::Kind::open)
      found.kind = Neighbour::Kind::sheared;
  }
  found.block = owner[0] + grid.blocks[0] * (owner[1] + grid.blocks[1] * owner[2]);
  return found;
}

}  // namespace stresslet
