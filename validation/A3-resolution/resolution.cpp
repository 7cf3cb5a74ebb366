/// Resolution of a sphere in shear, schemes of published work (Najuch, PhD thesis, University of Edinburgh 2018,
/// chapter 3): with superposition and the linear weight the sphere's surface lies off by a fixed part of a cell, so the
/// error of the stresslet falls with the first power of the cell; the usual sum of bounce-back misses the same part of
/// the stresslet at any resolution. Sub-cells beyond 10 a direction change little, to their limit, the exact overlap.
#include "validation/harness/shear_cell.hpp"

namespace stresslet::validation {

void resolution(Trial& trial) {
  // Exact value between walls five diameters apart, with periodic images: 1.0056.
  const double exact = 1.0056;
  const std::vector<int> sizes = trial.choose<std::vector<int>>({10, 14, 20}, {6, 8});
  const double tau = trial.choose(1.1, 1.4);
  trial.parameter("relaxation time", tau);
  std::vector<double> errors;
  Table table{"resolution",
              {{"N", "cells", ""}, {"S", "S0", "superposition"}, {"S", "S0", "bounce-back, usual"}},
              {{}, {}, {}}};
  for (const int n : sizes) {
    ShearCell cell{.scheme = thesis_scheme(tau), .cells_per_diameter = n, .fixed = true};
    const double found = run_shear_cell(trial, cell, fmt::format("A3, N = {}", n), 3e-4).stresslet;
    errors.push_back(found / exact - 1);
    cell.scheme.coupling_operator = "bounce-back";
    const ShearResult usual = run_shear_cell(trial, cell, fmt::format("A3, bounce-back, N = {}", n), 3e-4);
    table.values[0].push_back(n);
    table.values[1].push_back(found);
    table.values[2].push_back(usual.stresslet);
    if (n == sizes.back() && !trial.quick())
      trial.row(fmt::format("bounce-back, N = {}: usual sum", n), usual.stresslet, {0.4, "Najuch 2018: 40 % at any N"},
                absolute(0.1));
  }
  trial.table(table);
  trial.order_rows("stresslet, superposition", sizes, errors, 1, 0.6, 1.4);

  ShearCell cell{.scheme = thesis_scheme(tau), .cells_per_diameter = sizes[0], .fixed = true};
  const double sampled = run_shear_cell(trial, cell, "A3, sub-cells", 3e-4).stresslet;
  cell.scheme.fraction = "exact";
  trial.row("sub-cells against exact overlap: S", sampled,
            {run_shear_cell(trial, cell, "A3, exact overlap", 3e-4).stresslet, "limit of many sub-cells"},
            relative(0.003));
}

}  // namespace stresslet::validation
