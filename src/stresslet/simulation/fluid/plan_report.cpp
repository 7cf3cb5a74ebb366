#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "stresslet/simulation/fluid/plan.hpp"
#include "stresslet/simulation/progress.hpp"
#include "stresslet/simulation/report_lines.hpp"

namespace stresslet {

namespace {

constexpr double resolved_grid_reynolds = 10;  // a flow changes over some cells, and diffusion must still act there

std::string flow_lines(const FluidCase& c, const FluidPlan& p) {
  std::string text = "flow\n";
  text += line("Reynolds number", fmt::format("{:.6g}", p.reynolds), "U L / nu");
  if (p.angular_frequency > 0)
    text += line("Womersley number", fmt::format("{:.4g}", std::sqrt(p.angular_frequency * p.reynolds)),
                 fmt::format("L sqrt(omega / nu), period {:.4g} L/U", 2 * std::numbers::pi / p.angular_frequency));
  text += line("fastest velocity", fmt::format("{:.4g} U", c.fastest_velocity()), "of those that the input names");
  if (c.units) {
    const FluidUnitsInput& u = *c.units;
    text += line("SI", fmt::format("L {:.3g} m", u.length),
                 fmt::format("U = {:.3g} m/s, L/U = {:.3g} s, rho U^2 = {:.3g} Pa", u.velocity, u.length / u.velocity,
                             u.density * u.velocity * u.velocity));
  }
  return text;
}

std::string lattice_lines(const FluidCase& c, const FluidPlan& p) {
  const LatticeUnits& u = p.units;
  const Cells& n = p.setup.grid.size;
  const bool verified =
      u.relaxation_time >= lowest_verified_relaxation_time && u.relaxation_time <= highest_verified_relaxation_time;
  std::string text = "lattice\n";
  text += line("cells", fmt::format("{} x {} x {}", n[0], n[1], n[2]),
               fmt::format("{}, {}, {}", p.setup.stencil, keyword(c.lattice.precision), p.setup.collision));
  text += line("cell", fmt::format("{:.4g} L", u.cell));
  text += line("time step", fmt::format("{:.4g} L/U", u.step));
  text += line("relaxation time", fmt::format("{:.4g}", u.relaxation_time),
               fmt::format("{}{}", c.lattice.relaxation_time ? "as given; " : "",
                           verified ? "ok, verified from 0.51 to 3" : "outside 0.51 to 3, see below"));
  text +=
      line("Mach number", fmt::format("{:.4g}", u.mach),
           fmt::format("ok, at most {:.3g}; error about {:.1g} of the flow", c.lattice.largest_mach, u.mach * u.mach));
  text += line("grid Reynolds number", fmt::format("{:.4g}", u.grid_reynolds),
               u.grid_reynolds <= resolved_grid_reynolds ? "ok" : "high, see below");
  if (c.force)
    text += line("force", p.setup.forcing,
                 fmt::format("({:.4g}, {:.4g}, {:.4g}) rho U^2/L", p.force.x, p.force.y, p.force.z));
  return text;
}

std::string cost_lines(const FluidCase& c, const FluidPlan& p) {
  std::string text = "run\n";
  text += line("time", fmt::format("{:.6g} L/U", c.run.end_time), c.run.steady_tolerance ? "or until steady" : "");
  text += line("steps", fmt::format("{}", p.steps), fmt::format("a sample every {}", p.sample_every));
  text += line("threads", fmt::format("{}", p.threads));
  text += line("memory", memory_text(p.memory_bytes()), "populations, their copy for a checkpoint, samples");
  text += line("expected time", duration_text(p.expected_seconds()), "rough, see the progress line of the run");
  return text;
}

std::string warnings(const FluidCase& c, const FluidPlan& p) {
  const LatticeUnits& u = p.units;
  std::string text;
  const auto warn = [&](const std::string& message) { text += "  warning: " + message + "\n"; };
  if (u.relaxation_time < lowest_verified_relaxation_time)
    warn(fmt::format("relaxation time below {}: unverified, often unstable; raise domain.resolution",
                     lowest_verified_relaxation_time));
  if (u.relaxation_time > highest_verified_relaxation_time)
    warn(fmt::format("relaxation time above {}: unverified; expect errors where the flow is unsteady or curved",
                     highest_verified_relaxation_time));
  if (u.grid_reynolds > resolved_grid_reynolds)
    warn(
        fmt::format("grid Reynolds number above {:.0f}: layers thinner than a cell are possible; raise "
                    "domain.resolution",
                    resolved_grid_reynolds));
  if (c.lattice.collision == "BGK" && c.boundaries.open(1))
    warn("BGK: the position of walls depends on the relaxation time; TRT does not have this error");
  return text.empty() ? text : "warnings\n" + text;
}

}  // namespace

std::string plan_report(const FluidCase& settled, const FluidPlan& plan) {
  return flow_lines(settled, plan) + lattice_lines(settled, plan) + cost_lines(settled, plan) + warnings(settled, plan);
}

}  // namespace stresslet
