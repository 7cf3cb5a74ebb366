#include "stresslet/simulation/fluid/summary.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "stresslet/io/provenance.hpp"

namespace stresslet {

std::string fluid_summary_json(const FluidCase& settled, const FluidPlan& plan, std::int64_t steps,
                               double solid_fraction, const std::vector<Column>& columns,
                               const std::vector<double>& last, const FluidRunCost& cost, const std::string& status) {
  nlohmann::ordered_json j;
  j["status"] = status;
  j["fidelity"] = "fluid";
  j["version"] = provenance("", plan.threads, 0).version;
  j["reynolds"] = plan.reynolds;
  j["cells"] = plan.setup.grid.size;
  j["resolution"] = settled.domain.resolution;
  j["solid_fraction"] = solid_fraction;
  j["relaxation_time"] = plan.units.relaxation_time;
  j["mach"] = plan.units.mach;
  j["time_step"] = plan.units.step;
  j["steps"] = steps;
  for (std::size_t k = 0; k < columns.size(); ++k) j["last"][columns[k].name] = last[k];
  j["wall_seconds"] = cost.wall_seconds;
  j["cell_steps_per_second"] = cost.wall_seconds > 0 ? cost.cell_steps / cost.wall_seconds : 0.0;
  return j.dump(2) + "\n";
}

std::string fluid_summary_text(const std::vector<Column>& columns, const std::vector<double>& last) {
  std::string text = "\n";
  for (std::size_t k = 0; k < columns.size(); ++k)
    text +=
        fmt::format("{:<38}{:>14.7g}  {}\n", columns[k].name, last[k], columns[k].unit == "1" ? "" : columns[k].unit);
  while (text.ends_with("  \n")) text.replace(text.size() - 3, 3, "\n");
  return text;
}

}  // namespace stresslet
