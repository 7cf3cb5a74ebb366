#pragma once
/// Lengths of the sub-grid laws for the schemes that have been calibrated, one row each, as `stresslet calibrate`
/// prints them (docs/validation.md says with which residual errors). Lengths belong to a scheme, not to a viscosity,
/// where its results do not depend on the relaxation time; other schemes have a row per relaxation time.
#include <optional>
#include <string>
#include <vector>

#include "stresslet/coupling/subgrid/subgrid_links.hpp"

namespace stresslet {

struct CalibratedLengths {
  const char *coupling_operator, *weight, *collision, *law;
  double lowest_relaxation_time, highest_relaxation_time;
  SubgridLengths lengths;
  std::optional<SubgridLengths> at_walls;  ///< half-way walls; none: those of pairs serve
};

const std::vector<CalibratedLengths>& calibrated_lengths();

/// The correction for a scheme. Throws InputError where no row fits, naming the command that makes one.
SubgridCorrection calibrated_correction(const std::string& coupling_operator, const std::string& weight,
                                        const std::string& collision, double relaxation_time,
                                        const std::string& law = "soft-cut-off");

}  // namespace stresslet
