#pragma once
/// What the two kinds of calibration, of pairs and of walls, have in common: what was asked, and the file that says so.
#include <nlohmann/json.hpp>
#include <string>

#include "stresslet/coupling/calibration/calibrate.hpp"

namespace stresslet {

struct CalibrateArguments {
  PairScheme scheme;
  CalibrationPlan plan;
  std::string law = "soft-cut-off", output = "calibration.json", command_line;
  int threads = 2;
  bool wall = false, quick = false, quiet = false;
};

nlohmann::ordered_json lengths_json(const SubgridLengths& lengths);

/// One line for people.
void print_lengths(const CalibrateArguments& arguments, const SubgridLengths& lengths);

/// Provenance, scheme and law, then `results`. Throws Error where the file cannot be written.
void write_calibration(const CalibrateArguments& arguments, const nlohmann::ordered_json& results);

/// Spheres at half-way walls, in the place of pairs.
void calibrate_wall(const CalibrateArguments& arguments);

}  // namespace stresslet
