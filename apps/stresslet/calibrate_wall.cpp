#include <fmt/format.h>

#include "calibration_file.hpp"
#include "validation/harness/wall_calibration.hpp"

namespace stresslet {

void calibrate_wall(const CalibrateArguments& a) {
  validation::Trial trial(false, a.threads, a.quiet);
  const PairScheme& s = a.scheme;
  const auto measurements = validation::measure_at_wall(
      trial, {s.collision, s.coupling_operator, s.solid_fraction, s.weight, s.relaxation_time, s.magic_parameter},
      0.5 * a.plan.cells_across);
  const SubgridRange range;
  const SubgridLengths lengths = validation::fit_wall_lengths(measurements, a.law, range);

  print_lengths(a, lengths);
  fmt::print("error in per cent, without -> with the correction\n{:>6}{:>7}", "gap", "shift");
  for (const char* name : validation::wall_motion_names) fmt::print("{:>18}", name);
  fmt::print("\n");
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const validation::WallMeasurement& m : measurements) {
    const auto before = validation::corrected_errors(m, a.law, {}, range);
    const auto after = validation::corrected_errors(m, a.law, lengths, range);
    nlohmann::ordered_json row{{"gap", m.gap}, {"shift", m.shift}};
    fmt::print("{:>6.3g}{:>7.2g}", m.gap, m.shift);
    for (std::size_t k = 0; k < after.size(); ++k) {
      fmt::print("{:>9.1f} ->{:>6.1f}", 100 * before[k], 100 * after[k]);
      row[validation::wall_motion_names[k]] = {{"measured", m.measured[k]}, {"exact", m.exact[k]}, {"error", after[k]}};
    }
    fmt::print("\n");
    rows.push_back(std::move(row));
  }
  write_calibration(a,
                    {{"cells_across", a.plan.cells_across}, {"wall_lengths", lengths_json(lengths)}, {"walls", rows}});
}

}  // namespace stresslet
