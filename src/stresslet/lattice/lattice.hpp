#pragma once
/// The populations of the whole domain: a list of blocks, all in the same arrangement, and what steps them.
#include <cstdint>
#include <memory>
#include <vector>

#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lattice/grid.hpp"
#include "stresslet/lattice/moments.hpp"
#include "stresslet/lattice/populations.hpp"
#include "stresslet/lattice/sweep.hpp"

namespace stresslet {

template <class Stencil, class T>
struct Block {
  Cells origin;  ///< global coordinates of its cell (0, 0, 0)
  Populations<Stencil, T> populations;
};

template <class Stencil, class T>
struct Lattice {
  using StencilType = Stencil;
  using Value = T;

  explicit Lattice(const Grid& g) : grid(g) {
    for (const BlockBox& box : block_boxes(g)) blocks.push_back({box.origin, Populations<Stencil, T>(box.size)});
  }

  Grid grid;
  std::vector<Block<Stencil, T>> blocks;
  SweepInput input;
  Arrangement arrangement = Arrangement::arrived;
  std::int64_t steps = 0;

  // The image above a sheared boundary; lattice units.
  double shear_velocity = 0;    ///< of the image
  double shear_offset = 0;      ///< its displacement at the present time
  double departure_offset = 0;  ///< its displacement when the populations under way were collided
};

/// Calls `body(block, y, z)` for this member's share of the rows of every block.
template <class L, class Body>
void for_each_row(L& lattice, const Member& member, Body&& body) {
  for (auto& block : lattice.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const std::size_t ny = std::size_t(layout.size()[1]);
    const Range rows = member.share(layout.rows());
    for (std::size_t row = rows.begin; row < rows.end; ++row) body(block, int(row % ny), int(row / ny));
  }
}

/// What a cell is about to collide with: its incoming populations. In the arrangement `departing` cells at the rim of a
/// block read their halo, which must have been filled.
template <class Stencil, class T>
CellPopulations<Stencil, double> incoming(const Populations<Stencil, T>& populations, Arrangement arrangement,
                                          std::size_t index) {
  CellPopulations<Stencil, double> f;
  f.rest = populations.source(0, arrangement)[index];
  for (int k = 0; k < Stencil::pairs; ++k) {
    const double along = populations.source(first_of_pair(k), arrangement)[index];
    const double against = populations.source(first_of_pair(k) + 1, arrangement)[index];
    f.pair[k] = {along + against, along - against};
  }
  return f;
}

/// What keeps the populations right where they leave a block: halo exchange, walls, openings, the sheared boundary.
/// All members of the team call each hook; a barrier stands between hooks of different boundaries.
template <class Stencil, class T>
class Boundary {
 public:
  virtual ~Boundary() = default;
  /// Whether a hook reads populations in the halo that another boundary has brought there.
  virtual bool looks_across() const { return true; }
  /// Before every sweep: makes the populations that come in through this boundary.
  virtual void before_sweep(Lattice<Stencil, T>&, Member&) {}
  /// Once a step, between all `before_sweep` and the sweep: replaces populations for good.
  virtual void replace_before_sweep(Lattice<Stencil, T>&, Member&) {}
  /// After every sweep, before any `after_sweep`: reads what has gone out, changes no population.
  virtual void look_after_sweep(const Lattice<Stencil, T>&, Member&) {}
  /// After every sweep (`swept` is the arrangement it started from): brings what has gone out to where it belongs.
  virtual void after_sweep(Lattice<Stencil, T>&, Arrangement /*swept*/, Member&) {}

  /// Number of values that it keeps besides the incoming populations, in an order that does not depend on blocks.
  virtual std::size_t kept() const { return 0; }
  virtual void save(const Lattice<Stencil, T>&, double* /*kept*/) const {}
  /// In the arrangement `arrived`, as is `initialise`, which chooses the kept values to suit the populations.
  virtual void restore(Lattice<Stencil, T>&, const double* /*kept*/) {}
  virtual void initialise(Lattice<Stencil, T>&) {}
};

}  // namespace stresslet
