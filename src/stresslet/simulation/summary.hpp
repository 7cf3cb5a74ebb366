#pragma once
/// What a run found: means with error bars, from the series. Written as summary.json.
#include <functional>
#include <string>

#include "stresslet/rheology/statistics.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/series.hpp"

namespace stresslet {

/// How long the run took so far, restarts included.
struct RunCost {
  double wall_seconds = 0;
  double particle_steps = 0;
  TimeSpent spent;  ///< by the last process alone
};

/// First row to average: from run.average_from, or from the detected steady state of the viscosity.
struct AveragingWindow {
  std::size_t first_row = 0;
  bool steady = true;  ///< false where the series still drifts, or ended before run.average_from
};
AveragingWindow averaging_window(const Case& settled, const Series& series);

/// Mean over the window with its error.
Estimate mean_over(const Series& series, const AveragingWindow& window, const std::string& column);

/// JSON text. `status`: "finished", "interrupted" or "converged".
std::string summary_json(const Case& settled, const Plan& plan, const Series& series, double velocity_slope,
                         const RunCost& cost, const std::string& status);

/// The main numbers for people.
std::string summary_text(const Case& settled, const Series& series);

}  // namespace stresslet
