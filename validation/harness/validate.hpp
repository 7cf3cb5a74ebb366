#pragma once
/// Runs cases one after the other: table to stdout, files to the output folder, verdict.
#include <filesystem>
#include <span>
#include <string>

#include "stresslet/base/error.hpp"
#include "validation/harness/case.hpp"

namespace stresslet::validation {

struct ValidateOptions {
  std::filesystem::path output;
  bool folder_per_case = true;  ///< results of a case in OUTPUT/ID rather than OUTPUT
  bool quick = false, quiet = false;
  int threads = 1;
  std::string command_line = {};
};

/// ExitCode::disagreement if a row of any case lies outside its tolerance.
ExitCode validate(std::span<const Case> chosen, const ValidateOptions& options);

}  // namespace stresslet::validation
