/// Two walls near a sphere in shear raise its stresslet: by 0.72 % each at five radii, 0.09 % each at ten (exact,
/// method of fundamental solutions). With the scheme of the thesis, and with the default one.
#include "validation/harness/shear_cell.hpp"

namespace stresslet::validation {

void box_height(Trial& trial) {
  const double exact = 1 + 2 * 0.0072;
  if (trial.quick()) {
    // The smaller box of the independent program, whose walls and images raise the stresslet by 0.56 %.
    const ShearCell cell{.scheme = default_scheme(1.5), .fixed = true};
    trial.row("5x5x5, default scheme, tau 1.5, fixed: S/S0", run_shear_cell(trial, cell, "A2", 3e-4).stresslet,
              {1.0056, "exact, with walls and images"}, relative(0.015));
    return;
  }
  const ShearCell published{.scheme = thesis_scheme(0.7), .box = {10, 5, 10}};
  trial.row("10x5x10, superposition, tau 0.7: S/S0", run_shear_cell(trial, published, "A2, tau 0.7").stresslet,
            {1.0364, "independent program; Najuch 2018"}, absolute(0.002));
  const ShearCell own{.scheme = default_scheme(1), .box = {10, 5, 10}};
  trial.row("10x5x10, default scheme: S/S0", run_shear_cell(trial, own, "A2, default").stresslet,
            {exact, "exact, two walls"}, relative(0.015));
}

}  // namespace stresslet::validation
