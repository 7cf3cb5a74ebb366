#pragma once
/// One time step of the fluid.
#include <cmath>

#include "stresslet/lattice/lattice.hpp"

namespace stresslet {

template <class Stencil, class T>
using Boundaries = std::vector<std::unique_ptr<Boundary<Stencil, T>>>;

/// Fills what the next sweep reads from outside each block. Harmless to repeat.
template <class Stencil, class T>
void prepare_step(Lattice<Stencil, T>& lattice, const Boundaries<Stencil, T>& boundaries, Member& member) {
  for (const auto& boundary : boundaries) {
    boundary->before_sweep(lattice, member);
    member.barrier();
  }
}

/// Streams and collides every cell once. All members of the team call it; ends with a barrier.
template <class Stencil, class T>
void step(Lattice<Stencil, T>& lattice, Sweep<Stencil, T> sweep, const Boundaries<Stencil, T>& boundaries,
          Member& member) {
  prepare_step(lattice, boundaries, member);
  for (const auto& boundary : boundaries) boundary->replace_before_sweep(lattice, member);
  member.barrier();
  const Arrangement swept = lattice.arrangement;
  for (const auto& block : lattice.blocks) {
    const Range rows = member.share(block.populations.layout().rows());
    sweep(block.populations, swept, lattice.input, rows.begin, rows.end);
  }
  member.barrier();
  for (const auto& boundary : boundaries) boundary->look_after_sweep(lattice, member);
  member.barrier();
  for (const auto& boundary : boundaries) {
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

}  // namespace stresslet
