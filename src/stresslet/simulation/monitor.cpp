#include "stresslet/simulation/monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "stresslet/base/error.hpp"
#include "stresslet/lattice/moments.hpp"
#include "stresslet/simulation/cell_defect.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"

namespace stresslet {

namespace {

constexpr double monitor_window = 0.2;
constexpr double largest_sphere_mach = 0.3;  // density changes with its square

double mean_from(const std::vector<double>& values, std::size_t first) {
  return std::accumulate(values.begin() + long(first), values.end(), 0.0) / double(values.size() - first);
}

}  // namespace

void check_energy_balance(const Series& series, double tolerance) {
  constexpr std::size_t fewest_rows = 20;
  const double now = series["strain"].back();
  if (now < monitor_window || series.size() < fewest_rows) return;
  // The first row is taken at the start, before fluid and spheres have found their velocities.
  const std::size_t first = std::max<std::size_t>(series.first_row_from(now - monitor_window), 1);
  if (series.size() - first < fewest_rows) return;
  const double stress = mean_from(series["relative_viscosity"], first);
  const double dissipation = mean_from(series["relative_viscosity_from_dissipation"], first);
  if (std::abs(dissipation - stress) <= tolerance * std::abs(stress)) return;
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
