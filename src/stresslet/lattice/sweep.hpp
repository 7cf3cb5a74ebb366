#pragma once
/// The kernel: one time step of the bulk of a block, streaming and collision fused, in place (populations.hpp).
///
/// Reads and writes every population once: 2 * 19 * 8 = 304 bytes per cell and step for D3Q19 in double precision,
/// against some 200 (BGK, TRT) to 300 (MRT) operations: bound by memory. The same code serves both arrangements, which
/// differ in the addresses only; SIMD packs run along x, and the last pack of a row stores under a mask, so that a
/// cell's bits do not depend on its place in a block.
#include <string_view>

#include "stresslet/lattice/collision/rates.hpp"
#include "stresslet/lattice/forcing/no_force.hpp"
#include "stresslet/lattice/populations.hpp"

namespace stresslet {

struct SweepInput {
  RelaxationRates rates{};
  Vec3<double> force_density{};
};

/// Steps the rows [first, last) of the block, row = y + ny z.
template <class Stencil, class T>
using Sweep = void (*)(const Populations<Stencil, T>&, Arrangement, const SweepInput&, std::size_t first,
                       std::size_t last);

/// The kernel for these laws; both names must be in their lists (laws.hpp).
template <class Stencil, class T>
Sweep<Stencil, T> sweep_for(std::string_view collision, std::string_view forcing);

}  // namespace stresslet
