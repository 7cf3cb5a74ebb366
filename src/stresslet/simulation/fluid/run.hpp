#pragma once
/// Runs a fluid case from start or checkpoint to its end: steps, samples, fields, profiles, commits, summary.
#include <string>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/fluid/case.hpp"
#include "stresslet/simulation/run_options.hpp"

namespace stresslet {

/// Throws InputError before anything is written; NumericalFailure during the run, the last commit being kept.
/// Returns `success`, or `interrupted` after a stop.
ExitCode run_case(const FluidCase& settled, const RunOptions& options);

/// Continues the run in `options.output` from its checkpoint; `overrides` may change keys of [run] and of [output]
/// other than the sampling.
ExitCode restart_fluid_run(const std::vector<std::string>& overrides, const RunOptions& options);

}  // namespace stresslet
