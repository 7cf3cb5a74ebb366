#include "stresslet/simulation/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "stresslet/io/provenance.hpp"
#include "stresslet/rheology/steady_state.hpp"
#include "stresslet/simulation/stress_closure.hpp"

namespace stresslet {

AveragingWindow averaging_window(const Case& settled, const Series& series) {
  if (!settled.run.average_from) {
    const SteadyState steady = find_steady_state(series["relative_viscosity"]);
    return {steady.begin, steady.reached};
  }
  const std::size_t first = series.first_row_from(*settled.run.average_from);
  return first < series.size() ? AveragingWindow{first, true} : AveragingWindow{series.size() / 2, false};
}

Estimate mean_over(const Series& series, const AveragingWindow& window, const std::string& column) {
  return estimate_mean(std::span(series[column]).subspan(window.first_row));
}

namespace {

nlohmann::ordered_json as_json(const Estimate& e) { return {{"mean", e.mean}, {"error", e.error}}; }

/// Mean of `closure_differences`, relative to the flux.
Estimate stress_closure(const Series& series, const AveragingWindow& window) {
  Estimate closure = estimate_mean(closure_differences(series, window.first_row));
  const double scale = mean_over(series, window, "relative_viscosity_through_plane").mean;
  closure.mean /= scale, closure.error /= std::abs(scale);
  return closure;
}

struct DensityExtremes {
  double lowest, highest;
};
DensityExtremes density_extremes(const Series& series) {
  const auto &low = series["lowest_density"], &high = series["highest_density"];
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

std::string fluid_lines(const Series& series, const AveragingWindow& window) {
  constexpr double wide = 0.1;
  std::string text;
  if (series.has("relative_viscosity_through_plane")) {
    const Estimate plane = mean_over(series, window, "relative_viscosity_through_plane");
    const Estimate closure = stress_closure(series, window);
    text +=
        fmt::format("  through the plane       {:>9.4g} +- {:.2g}   (summed stress differs by {:.2g} +- {:.1g} %)\n",
                    plane.mean, plane.error, 100 * closure.mean, 100 * closure.error);
  }
  const DensityExtremes density = density_extremes(series);
  text += fmt::format("density of the fluid      {:>9.4g} to {:.4g}{}\n", density.lowest, density.highest,
                      density.highest - density.lowest > wide
                          ? "   (compressed: the viscosity reads some per cent low; lower the relaxation time)"
                          : "");
  return text;
}

}  // namespace

std::string summary_json(const Case& settled, const Plan& plan, const Series& series, double velocity_slope,
                         const RunCost& cost, const std::string& status) {
  const AveragingWindow window = averaging_window(settled, series);
  const auto mean = [&](const std::string& column) { return mean_over(series, window, column); };
  const Estimate viscosity = mean("relative_viscosity");
  const auto& strain = series["strain"];
  const double sample_strain = series.size() > 1 ? strain[1] - strain[0] : 0.0;
  const auto& overlap = series["largest_overlap"];

  nlohmann::ordered_json j;
  j["status"] = status;
  j["fidelity"] = keyword(settled.fidelity);
  j["version"] = provenance("", plan.threads, settled.suspension.seed).version;
  j["solid_fraction"] = plan.solid_fraction;
  j["particles"] = plan.count();
  j["strain"] = strain.back();
  j["average_from"] = strain[window.first_row];
  j["steady"] = window.steady;
  j["relative_viscosity"] = as_json(viscosity);
  j["relative_viscosity"]["reliable"] = viscosity.reliable;
  j["relative_viscosity"]["correlation_strain"] = viscosity.correlation_samples * sample_strain;
  j["relative_viscosity_from_dissipation"] = as_json(mean("relative_viscosity_from_dissipation"));
  StressParts::for_each(StressParts{}, [&](const char* part, const Stress&) {
    j["contribution"][part] = as_json(mean(std::string(part) + "_xy"));
  });
  for (const char* column : {"N1", "N2", "particle_pressure", "contacts_per_particle"})
    j[column] = as_json(mean(column));
  j["largest_overlap"] = *std::max_element(overlap.begin() + long(window.first_row), overlap.end());
  j["velocity_slope"] = velocity_slope;
  j["wall_seconds"] = cost.wall_seconds;
  j["particle_steps_per_second"] = cost.wall_seconds > 0 ? cost.particle_steps / cost.wall_seconds : 0.0;
  j["seconds_per_unit_strain"] = strain.back() > 0 ? cost.wall_seconds / strain.back() : 0.0;
  if (cost.spent.sum() > 0) {
    const TimeSpent& t = cost.spent;
    const double all = t.sum();
    j["time_share"] = {{"particles", t.particles / all}, {"analysis", t.analysis / all}, {"output", t.output / all}};
    if (plan.resolved) j["time_share"].update({{"coupling", t.coupling / all}, {"lattice", t.lattice / all}});
  }
  if (plan.resolved) {
    const ResolvedSetup& r = *plan.resolved;
    j["relaxation_time"] = r.rates.relaxation_time;
    j["reynolds_number"] = r.reynolds;
    j["cells_per_diameter"] = 1 / r.cell;
    StressParts::for_each(StressParts{}, [&](const std::string& part, const Stress&) {
      if (part.starts_with("lubrication")) j["virtual_films"][part] = as_json(mean("virtual_" + part + "_xy"));
    });
    if (series.has("relative_viscosity_through_plane")) j["stress_closure"] = as_json(stress_closure(series, window));
    const DensityExtremes density = density_extremes(series);
    j["lowest_density"] = density.lowest;
    j["highest_density"] = density.highest;
    j["lattice_updates_per_second"] =
        cost.wall_seconds > 0 ? cost.particle_steps / double(plan.count()) * r.cell_count() / cost.wall_seconds : 0.0;
  }
  return j.dump(2) + "\n";
}

std::string summary_text(const Case& settled, const Series& series) {
  const AveragingWindow window = averaging_window(settled, series);
  const auto mean = [&](const std::string& column) { return mean_over(series, window, column); };
  const Estimate viscosity = mean("relative_viscosity");
  const auto& strain = series["strain"];
  std::string text =
      fmt::format("\nrelative viscosity        {:>9.4g} +- {:.2g}   (strain {:.4g} to {:.4g}{})\n", viscosity.mean,
                  viscosity.error, strain[window.first_row], strain.back(), window.steady ? "" : "; not yet steady");
  const Estimate dissipated = mean("relative_viscosity_from_dissipation");
  text += fmt::format("  from dissipation        {:>9.4g} +- {:.2g}\n", dissipated.mean, dissipated.error);
  if (settled.resolved()) text += fluid_lines(series, window);
  text += "carried by\n";
  text += fmt::format("  {:<24}{:>9.4g}\n", "fluid", 1.0);
  StressParts::for_each(StressParts{}, [&](std::string part, const Stress&) {
    const Estimate e = mean(part + "_xy");
    if (e.mean == 0 && e.error == 0) return;
    std::replace(part.begin(), part.end(), '_', ' ');
    text += fmt::format("  {:<24}{:>9.4g} +- {:.2g}\n", part, e.mean, e.error);
  });
  for (const char* column : {"N1", "N2"}) {
    const Estimate e = mean(column);
    text += fmt::format("{:<26}{:>9.4g} +- {:.2g}\n", column, e.mean, e.error);
  }
  return text;
}

}  // namespace stresslet
