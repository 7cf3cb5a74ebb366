#pragma once
/// Every covered cell one by one, for reports: where on a sphere it takes what from the fluid. The kernels sum the same
/// in packs (resolved_sweep.hpp), with the kinetic stress; this is the slow, plain version.
#include <functional>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/lattice/stencil/d3q19.hpp"

namespace stresslet {

struct ReportedCell {
  std::size_t sphere;
  Cells cell;          ///< global
  Vec3<double> arm;    ///< from the sphere's centre
  double drag, share;  ///< alpha_k and B_k (shared_cells.hpp)
  double density;
  Vec3<double> velocity;  ///< u* in the sphere's own frame
};

/// After `fill_drags` of all runs, with the incoming populations as `gather_exchange` reads them; a cell comes once per
/// image in it.
void for_each_covered_cell(const Lattice<D3Q19, double>& lattice, const CoveredRuns<double>& covered,
                           const std::function<void(const ReportedCell&)>& visit);

}  // namespace stresslet
