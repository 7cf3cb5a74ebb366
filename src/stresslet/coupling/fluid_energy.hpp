#pragma once
/// One look over the whole lattice with spheres in it: where the fluid's energy goes, and whether the fluid is sound.
///
/// The lattice has an exact balance of energy at small velocities. With n = f - feq(u*) before and n' after a collision
/// at us = u*, and K = rho u^2/2 + rho cs^2 (rho - 1)^2/2 per cell, streaming keeps  sum f^2/(6 w)  over cells and
/// populations, so that a step changes it by
///   sum F.u  -  sum over cells, i of (n_i^2 - n'_i^2)/(6 w_i),
/// F = e B rho (us - u*) the momentum given to the fluid (e: `exchange` of the operator) and u = u* + F/(2 rho) the
/// mean velocity over the step; n without what motion past the lattice adds to it (advected_moments.hpp). The shear
/// moments of the last sum are 2 nu rho E:E; the others, of the order of the truncation in smooth flow, add up to some
/// per cent at the rims of spheres. The spheres of a cell (shared_cells.hpp) spend  sum_k F_k.us_k, so that
///   slip = e rho [B (1 - e B/2) (us - u*)^2 + sum_k B_k us_k^2 - B us^2]
/// is lost between solid and fluid, besides the friction between the spheres. Without body force.
///
/// Reads 152 bytes per cell in double precision, about 300 flops, in packs; once a sample. Sums of a row are taken in
/// the precision of the lattice.
#include <string_view>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/lattice/fluid.hpp"

namespace stresslet {

/// The fluid that no sphere touches, in a plane of cells across y or part of one.
struct FreeFluid {
  double cells = 0;
  double velocity = 0;  ///< sum of u_x over them, lattice units

  FreeFluid& operator+=(const FreeFluid& other) {
    cells += other.cells;
    velocity += other.velocity;
    return *this;
  }
};

/// Sums over all cells in lattice units; the same bits for any number of threads.
struct FluidEnergy : DensityRange {
  double collisions = 0;          ///< dissipated a step, by collisions
  double slip = 0;                ///< dissipated a step, between solid and fluid
  SymTensor3<double> reynolds{};  ///< sum rho u' u', u' = u less the mean shear flow
  double stored_momentum = 0;     ///< sum rho u*'_x y, y from the middle of the domain
  FreeFluid free;

  double kinetic() const { return 0.5 * trace(reynolds); }
};

/// Of rows of cells, before they collide, each to its place in `by_row`. `covered` holds the drags of the rows' runs;
/// `shear_rate` of the mean flow.
template <class Stencil, class T>
using RowEnergy = void (*)(const Lattice<Stencil, T>& lattice, int block, const CoveredRuns<T>& covered,
                           const std::vector<ResolvedSphere>& spheres, double shear_rate, const Range& rows,
                           FluidEnergy* by_row);

template <class Stencil, class T>
RowEnergy<Stencil, T> row_energy_for(std::string_view collision, std::string_view coupling_operator);

/// Of row after row, in order.
void add_row(FluidEnergy& sum, const FluidEnergy& row);

}  // namespace stresslet
