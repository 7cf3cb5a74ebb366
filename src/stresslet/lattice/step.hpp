#pragma once
/// One time step of the fluid.
#include <algorithm>
#include <cmath>
#include <memory>

#include "stresslet/lattice/boundary/row_exchange.hpp"
#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

/// When the exchange of rows is done: for all of them before and after the sweep, or by the sweep itself.
enum class RowsExchanged { around_sweep, in_sweep };

template <class Stencil, class T>
struct Boundaries {
  RowExchange<Stencil, T> rows;
  std::vector<std::unique_ptr<Boundary<Stencil, T>>> others;  ///< in the order in which they act, after `rows`

  /// Whether rows may be exchanged one by one, when they are swept.
  bool row_by_row() const {
    return std::none_of(others.begin(), others.end(), [](const auto& boundary) { return boundary->looks_across(); });
  }
  RowsExchanged rows_exchanged() const { return row_by_row() ? RowsExchanged::in_sweep : RowsExchanged::around_sweep; }
  /// What a sweep from this arrangement exchanges itself, row by row; null if nothing.
  const RowExchange<Stencil, T>* in_sweep(Arrangement arrangement) const {
    return row_by_row() && arrangement == Arrangement::departing ? &rows : nullptr;
  }
};

/// Fills what the next sweep reads from outside each block. Harmless to repeat.
template <class Stencil, class T>
void prepare_step(Lattice<Stencil, T>& lattice, const Boundaries<Stencil, T>& boundaries, Member& member,
                  RowsExchanged rows = RowsExchanged::around_sweep) {
  if (rows == RowsExchanged::around_sweep && lattice.arrangement == Arrangement::departing) {
    for_each_row(lattice, member, [&](const auto& block, int y, int z) {
      boundaries.rows.bring_in(int(&block - lattice.blocks.data()), y, z);
    });
    member.barrier();
  }
  for (const auto& boundary : boundaries.others) {
    boundary->before_sweep(lattice, member);
    member.barrier();
  }
}

/// After `prepare_step`, once: the populations that boundaries replace before a sweep. Ends with a barrier.
template <class Stencil, class T>
void replace_populations(Lattice<Stencil, T>& lattice, const Boundaries<Stencil, T>& boundaries, Member& member) {
  for (const auto& boundary : boundaries.others) boundary->replace_before_sweep(lattice, member);
  member.barrier();
}

/// After the sweep: brings what has gone out to where it belongs, and goes on to the next time. Begins and ends with a
/// barrier.
template <class Stencil, class T>
void finish_step(Lattice<Stencil, T>& lattice, const Boundaries<Stencil, T>& boundaries, Member& member,
                 RowsExchanged rows = RowsExchanged::around_sweep) {
  member.barrier();
  const Arrangement swept = lattice.arrangement;
  for (const auto& boundary : boundaries.others) boundary->look_after_sweep(lattice, member);
  member.barrier();
  if (rows == RowsExchanged::around_sweep && swept == Arrangement::departing) {
    for_each_row(lattice, member, [&](const auto& block, int y, int z) {
      boundaries.rows.bring_out(int(&block - lattice.blocks.data()), y, z);
    });
    member.barrier();
  }
  for (const auto& boundary : boundaries.others) {
    boundary->after_sweep(lattice, swept, member);
    member.barrier();
  }
  if (member.rank() == 0) {
    lattice.arrangement = other(swept);
    ++lattice.steps;
    lattice.departure_offset = lattice.shear_offset;
    lattice.shear_offset = std::fmod(lattice.shear_offset + lattice.shear_velocity, double(lattice.grid.size[0]));
  }
  member.barrier();
}

/// Sweeps this member's rows of all blocks with the exchange across x faces. Blocks side by side in x take turns row by
/// row, so that both ends of a link are in cache.
template <class Stencil, class T>
void sweep_and_exchange(const Lattice<Stencil, T>& lattice, Sweep<Stencil, T> sweep,
                        const RowExchange<Stencil, T>& exchange, const Member& member) {
  const int side_by_side = lattice.grid.blocks[0];
  for (int first = 0; first < int(lattice.blocks.size()); first += side_by_side) {
    const BlockLayout& layout = lattice.blocks[std::size_t(first)].populations.layout();
    const std::size_t ny = std::size_t(layout.size()[1]);
    const Range rows = member.share(layout.rows());
    for (std::size_t row = rows.begin; row < rows.end; ++row) {
      const int y = int(row % ny), z = int(row / ny);
      for (int b = first; b < first + side_by_side; ++b) {
        exchange.bring_in(b, y, z);
        sweep(lattice.blocks[std::size_t(b)].populations, lattice.arrangement, lattice.input, row, row + 1);
        exchange.bring_out(b, y, z);
      }
    }
  }
}

/// Streams and collides every cell once. All members of the team call it; ends with a barrier.
template <class Stencil, class T>
void step(Lattice<Stencil, T>& lattice, Sweep<Stencil, T> sweep, const Boundaries<Stencil, T>& boundaries,
          Member& member) {
  const RowsExchanged rows = boundaries.rows_exchanged();
  prepare_step(lattice, boundaries, member, rows);
  replace_populations(lattice, boundaries, member);
  if (const auto* across_x = boundaries.in_sweep(lattice.arrangement)) {
    sweep_and_exchange(lattice, sweep, *across_x, member);
  } else {
    for (const auto& block : lattice.blocks) {
      const Range mine = member.share(block.populations.layout().rows());
      sweep(block.populations, lattice.arrangement, lattice.input, mine.begin, mine.end);
    }
  }
  finish_step(lattice, boundaries, member, rows);
}

}  // namespace stresslet
