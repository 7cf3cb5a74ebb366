#pragma once
/// What a fluid run found, as summary.json and for people.
#include <map>
#include <string>
#include <vector>

#include "stresslet/io/results_data.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

struct FluidRunCost {
  double wall_seconds = 0, cell_steps = 0;  ///< restarts included
};

/// JSON text. `last` is the last row of the series. `status`: "finished", "steady" or "interrupted".
std::string fluid_summary_json(const FluidCase& settled, const FluidPlan& plan, std::int64_t steps,
                               double solid_fraction, const std::vector<Column>& columns,
                               const std::vector<double>& last, const FluidRunCost& cost, const std::string& status);

std::string fluid_summary_text(const std::vector<Column>& columns, const std::vector<double>& last);

}  // namespace stresslet
