#include "stresslet/coupling/subgrid/calibrated_lengths.hpp"

#include <fmt/format.h>

#include "stresslet/base/error.hpp"

namespace stresslet {

const std::vector<CalibratedLengths>& calibrated_lengths() {
  // The default scheme; guo-form differs from superposition by less than the digits printed.
  constexpr SubgridLengths of_pairs{0.561, 0.142, 0.269}, at_walls{0.452, 0.199, 0.013};
  static const std::vector<CalibratedLengths> rows{
      {"superposition", "viscosity-scaled", "TRT", "soft-cut-off", 0.55, 3, of_pairs, at_walls},
      {"guo-form", "viscosity-scaled", "TRT", "soft-cut-off", 0.55, 3, of_pairs, at_walls},
      // Their weight depends on the relaxation time, and so do the lengths.
      {"bounce-back",
       "noble-torczynski",
       "TRT",
       "soft-cut-off",
       1,
       1,
       {0.782, 0.346, 0.710},
       SubgridLengths{0.553, 0.459, 0.368}},
      {"half-holdych",
       "noble-torczynski",
       "TRT",
       "soft-cut-off",
       1,
       1,
       {1.013, 0.488, 0.882},
       SubgridLengths{0.695, 0.514, 0.429}},
      // The thesis preset with its published lengths: Najuch (2018), ch. 4.
      {"superposition", "linear", "BGK", "hard-cut-off", 0.65, 0.65, {0.75, 0.05, 0.04}, {}},
  };
  return rows;
}

SubgridCorrection calibrated_correction(const std::string& coupling_operator, const std::string& weight,
                                        const std::string& collision, double relaxation_time, const std::string& law) {
  std::string known = "superposition, viscosity-scaled and TRT";
  for (const CalibratedLengths& row : calibrated_lengths()) {
    if (row.coupling_operator != coupling_operator || row.weight != weight || row.collision != collision ||
        row.law != law)
      continue;
    if (row.lowest_relaxation_time <= relaxation_time && relaxation_time <= row.highest_relaxation_time)
      return {law, row.lengths, {}, row.at_walls};
    known = fmt::format("a relaxation time between {} and {}", row.lowest_relaxation_time, row.highest_relaxation_time);
  }
  throw InputError({"",
                    fmt::format("no calibrated sub-grid correction {} for the operator {} with the weight {}, "
                                "collision {}, relaxation time {}",
                                law, coupling_operator, weight, collision, relaxation_time),
                    "what the grid resolves of a thin film depends on all of them",
                    fmt::format("give the lengths that `stresslet calibrate --law {} --operator {} --weight {} "
                                "--collision {} --tau {}` finds, or take {}",
                                law, coupling_operator, weight, collision, relaxation_time, known)});
}

}  // namespace stresslet
