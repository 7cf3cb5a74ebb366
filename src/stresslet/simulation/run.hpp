#pragma once
/// Runs a case from start or checkpoint to its end: steps, samples, snapshots, monitor, commits, summary.
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/case.hpp"

namespace stresslet {

struct RunOptions {
  std::filesystem::path output;
  bool force = false;
  bool quiet = false;                       ///< no progress line
  std::string command_line;                 ///< for the provenance
  const std::atomic<bool>* stop = nullptr;  ///< set from outside to end the run with a checkpoint
};

/// Throws InputError before anything is written; NumericalFailure during the run, the last commit being kept.
/// Returns `success`, or `interrupted` after a stop.
ExitCode run_case(const Case& settled, const RunOptions& options);

/// Continues the run in `options.output` from its checkpoint; `overrides` may change keys of [run] and of [output]
/// other than the sampling.
ExitCode restart_run(const std::vector<std::string>& overrides, const RunOptions& options);

}  // namespace stresslet
