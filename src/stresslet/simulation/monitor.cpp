#include "stresslet/simulation/monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>

#include "stresslet/base/error.hpp"
#include "stresslet/lattice/moments.hpp"
#include "stresslet/simulation/cell_defect.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/stress_closure.hpp"

namespace stresslet {

namespace {

constexpr double monitor_window = 0.2;
constexpr double largest_sphere_mach = 0.3;  // density changes with its square

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Thirty standard errors of the mean of these values, taken as independent: with the default tolerance, 0.1, a mean
/// within three of zero is chance. Collisions that are shorter than the time between samples make samples scatter.
double scatter(std::span<const double> values) {
  const double mean = mean_of(values), n = double(values.size());
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return 30 * std::sqrt(squares / (n * (n - 1)));
}

/// Whether the mean of `differences` is small against `size`, or chance.
bool agree(std::span<const double> differences, double size, double tolerance) {
  return std::abs(mean_of(differences)) <= tolerance * (std::abs(size) + scatter(differences));
}

/// First row of the last `monitor_window`; none before there is one with rows enough.
std::optional<std::size_t> window_start(const Series& series) {
  constexpr std::size_t fewest_rows = 20;
  const double now = series["strain"].back();
  if (now < monitor_window || series.size() < fewest_rows) return std::nullopt;
  // The first row is taken at the start, before fluid and spheres have found their velocities.
  const std::size_t first = std::max<std::size_t>(series.first_row_from(now - monitor_window), 1);
  if (series.size() - first < fewest_rows) return std::nullopt;
  return first;
}

}  // namespace

void check_energy_balance(const Series& series, double tolerance) {
  const std::optional<std::size_t> first = window_start(series);
  if (!first) return;
  const double now = series["strain"].back();
  const auto from_stress = std::span(series["relative_viscosity"]).subspan(*first),
             from_dissipation = std::span(series["relative_viscosity_from_dissipation"]).subspan(*first);
  const double stress = mean_of(from_stress), dissipation = mean_of(from_dissipation);
  std::vector<double> differences(from_stress.size());
  std::transform(from_dissipation.begin(), from_dissipation.end(), from_stress.begin(), differences.begin(),
                 std::minus<>());
  if (agree(differences, stress, tolerance)) return;
  throw NumericalFailure(
      {"",
       fmt::format("stress power and dissipation part: relative viscosity {:.4g} from stress, {:.4g} from "
                   "dissipation, between strain {:.4g} and {:.4g}",
                   stress, dissipation, now - monitor_window, now),
       "what the stress puts in must be dissipated or stored; a time step that is too long does not blow up but "
       "oscillates in the thin films and loses contacts, and then the viscosity is wrong too",
       "start a new run with a smaller time.step, or with time.scheme = \"semi-implicit\"; only where the mismatch is "
       "known to be harmless, go on with a larger run.monitor_tolerance"});
}

void check_stress_closure(const Series& series, double tolerance) {
  const std::optional<std::size_t> first = window_start(series);
  if (!first || !series.has("relative_viscosity_through_plane")) return;
  const double now = series["strain"].back();
  const double flux = mean_of(std::span(series["relative_viscosity_through_plane"]).subspan(*first));
  const std::vector<double> differences = closure_differences(series, *first);
  if (agree(differences, flux, tolerance)) return;
  throw NumericalFailure(
      {"",
       fmt::format("the summed stress and the flux of momentum through the sheared plane, or into the walls, part: "
                   "relative viscosity {:.4g} from the sum, growth of momentum included, {:.4g} from the flux, between "
                   "strain {:.4g} and {:.4g}",
                   flux + mean_of(differences), flux, now - monitor_window, now),
       "momentum that the spheres hand on must come out of the box; a fluid that is compressed, or near instability, "
       "keeps it",
       "start a new run with a smaller resolution.relaxation_time or flow.reynolds, or with more "
       "resolution.cells_per_diameter; only where the mismatch is known to be harmless, go on with a larger "
       "run.monitor_tolerance"});
}

void check_finite(const Suspension& s) {
  const auto fail = [&](std::size_t i, const char* quantity, const Vec3<double>& v) {
    throw NumericalFailure({"",
                            fmt::format("particle {} has {} ({}, {}, {}) at strain {:.6g}", s.state.id[i], quantity,
                                        v.x, v.y, v.z, s.strain),
                            "a number that is not finite spreads to all neighbours within a few steps",
                            "look at the last snapshot around this particle; a new run with a smaller time.step or a "
                            "stiffer contact usually "
                            "cures it"});
  };
  const auto finite = [](const Vec3<double>& v) { return std::isfinite(v.x + v.y + v.z); };
  for (std::size_t i = 0; i < s.state.size(); ++i) {
    if (!finite(s.state.position(i))) fail(i, "position", s.state.position(i));
    if (!finite(s.state.velocity(i))) fail(i, "velocity", s.state.velocity(i));
    if (!finite(s.state.angular_velocity(i))) fail(i, "angular velocity", s.state.angular_velocity(i));
  }
}

void check_fluid(const Suspension& s) {
  const FluidEnergy& look = s.resolved->last_look();
  const auto complaint =
      cell_defect(look.worst_cell, look.worst_density(), look.finite, fmt::format("strain {:.6g}", s.strain),
                  "start a new run with a smaller resolution.relaxation_time or flow.reynolds, or with more "
                  "resolution.cells_per_diameter");
  if (complaint) throw NumericalFailure(*complaint);
}

void check_sphere_speeds(const Suspension& s) {
  const double to_mach = s.time.step / (s.resolved->setup().cell * std::sqrt(speed_of_sound_squared));
  for (std::size_t i = 0; i < s.state.size(); ++i) {
    const double mach = to_mach * norm(s.state.velocity(i));
    if (!(mach > largest_sphere_mach)) continue;
    throw NumericalFailure(
        {fmt::format("strain {:.6g}", s.strain),
         fmt::format("particle {} moves at Mach number {:.3g}", s.state.id[i], mach),
         fmt::format("above {} the lattice does not follow a solid: the fluid is compressed and the forces are wrong",
                     largest_sphere_mach),
         "look at the last snapshot around this particle; start a new run with a smaller resolution.relaxation_time "
         "or flow.reynolds"});
  }
}

void check_solver(const Suspension& s) {
  if (s.solver_report.converged) return;
  throw NumericalFailure(
      {"",
       fmt::format("the velocity solve stopped at residual {:.3g} after {} iterations, at strain {:.6g}",
                   s.solver_report.residual, s.solver_report.iterations, s.strain),
       "the system of lubrication and drag is too ill-conditioned for its tolerance, so velocities would be wrong",
       "start a new run with a smaller time.step, or with a larger lubrication.inner_cutoff"});
}

void check_explicit_step(double step_number, double step) {
  constexpr double stable = 2.0;
  if (step_number < stable) return;
  throw NumericalFailure(
      {"",
       fmt::format("the time step {:.3g} exceeds {:.3g}, the stable one of the present network of films", step,
                   step * stable / step_number),
       "a particle squeezed by several neighbours relaxes faster than a pair; an unstable step does not blow up but "
       "loses contacts silently",
       fmt::format("start a new run with time.step below {:.2g}, or with time.scheme = \"semi-implicit\"",
                   0.8 * step * stable / step_number)});
}

}  // namespace stresslet
