#pragma once
/// The two kernels of the resolved fluid.
///
/// `gather_exchange` finds the solid drags and reads the incoming populations of the covered cells before they collide:
/// 152 bytes per covered cell in double precision, 76 in single, in runs along x, in the order of the lattice's memory.
/// `resolved_sweep` is the kernel of lattice/sweep.hpp with the coupling operator in the covered packs of a row, which
/// it finds in a buffer of the row; the other packs are those of the plain fluid.
#include <string_view>
#include <vector>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/coupling/exchange_sums.hpp"
#include "stresslet/lattice/boundary/row_exchange.hpp"

namespace stresslet {

/// What the sums need to know of the coupling operator.
struct ExchangeFactors {
  double exchange = 1;        ///< momentum given to the fluid, over B rho (us - u*)
  double kinetic_stress = 0;  ///< operators/kinetic_stress.hpp
};

/// Friction of the run at `slot`, of image `first`, with the image `second` > `first` (shared_cells.hpp).
struct SharedRun {
  std::int32_t slot, first, second;
  double coefficient = 0;          ///< sum c
  Vec3<double> coefficient_arm{};  ///< sum c r, r from the centre of the first
};

/// Sums of every run in the rows [first, last) of block `block`, by slot; `shared` takes those with friction. Before a
/// row is read, what comes in across x faces is brought in by `across_x`, if any.
template <class Stencil, class T>
void gather_exchange(const Lattice<Stencil, T>& lattice, int block, const RowExchange<Stencil, T>* across_x,
                     CoveredRuns<T>& covered, const ExchangeFactors& factors, std::size_t first, std::size_t last,
                     SlotSums& by_slot, std::vector<SharedRun>& shared);

/// Steps the rows [first, last) of block `block`, each with its exchange across x faces by `across_x`, if any;
/// `spheres` hold the velocities at which the solid moves.
template <class Stencil, class T>
using ResolvedSweep = void (*)(const Lattice<Stencil, T>& lattice, int block, const RowExchange<Stencil, T>* across_x,
                               const CoveredRuns<T>& covered, const std::vector<ResolvedSphere>& spheres,
                               std::size_t first, std::size_t last);

/// The kernel for these laws; both names must be in their lists. `forced`: with a body force, in Guo's form.
template <class Stencil, class T>
ResolvedSweep<Stencil, T> resolved_sweep_for(std::string_view collision, std::string_view coupling_operator,
                                             bool forced);

}  // namespace stresslet
