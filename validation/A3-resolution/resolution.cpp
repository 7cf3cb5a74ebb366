/// Resolution of a sphere in shear, schemes of published work (Najuch, PhD thesis, University of Edinburgh 2018,
/// chapter 3): with superposition and the linear weight the sphere's surface lies off by a fixed part of a cell, so the
/// error of the stresslet falls with the first power of the cell; the usual sum of bounce-back misses the same part of
/// the stresslet at any resolution. Sub-cells beyond 10 a direction change little, to their limit, the exact overlap.
#include "validation/harness/shear_cell.hpp"

namespace stresslet::validation {

namespace {

void usual_sum_of_bounce_back(Trial& trial) {
  Table table{"bounce-back", {{"N", "cells", ""}, {"S", "S0", "usual sum, tau 0.7"}}, {{}, {}}};
  for (const int n : {10, 20}) {
    const ShearCell cell{.scheme = thesis_scheme(0.7, "bounce-back"), .cells_per_diameter = n, .fixed = true};
    const double found = run_shear_cell(trial, cell, fmt::format("A3, bounce-back, N = {}", n), 3e-4).stresslet;
    trial.row(fmt::format("bounce-back, tau 0.7, N = {}: usual sum", n), found, {0.4, "Najuch 2018: 40 % at any N"},
              absolute(0.1));
    table.values[0].push_back(n);
    table.values[1].push_back(found);
  }
  trial.table(table);
}

}  // namespace

void resolution(Trial& trial) {
  // Exact value between walls five diameters apart, with periodic images: 1.0056.
  const double exact = 1.0056;
  const std::vector<int> sizes = trial.choose<std::vector<int>>({10, 14, 20}, {6, 8});
  const double tau = trial.choose(1.1, 1.4);
  trial.parameter("relaxation time", tau);
  std::vector<double> errors;
  Table table{"resolution", {{"N", "cells", ""}, {"S", "S0", "superposition"}}, {{}, {}}};
  for (const int n : sizes) {
    const ShearCell cell{.scheme = thesis_scheme(tau), .cells_per_diameter = n, .fixed = true};
    const double found = run_shear_cell(trial, cell, fmt::format("A3, N = {}", n), 3e-4).stresslet;
    errors.push_back(found / exact - 1);
    table.values[0].push_back(n);
    table.values[1].push_back(found);
  }
  trial.table(table);
  trial.order_rows("stresslet, superposition", sizes, errors, 1, 0.6, 1.4);

  ShearCell cell{.scheme = thesis_scheme(tau), .cells_per_diameter = sizes[0], .fixed = true};
  const double sampled = run_shear_cell(trial, cell, "A3, sub-cells", 3e-4).stresslet;
  cell.scheme.fraction = "exact";
  trial.row("sub-cells against exact overlap: S", sampled,
            {run_shear_cell(trial, cell, "A3, exact overlap", 3e-4).stresslet, "limit of many sub-cells"},
            relative(0.003));
  if (!trial.quick()) usual_sum_of_bounce_back(trial);
}

}  // namespace stresslet::validation
