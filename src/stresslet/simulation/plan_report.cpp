#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/progress.hpp"
#include "stresslet/simulation/report_lines.hpp"
#include "stresslet/simulation/resolved/resolved_plan.hpp"

namespace stresslet {

namespace {

std::string suspension_lines(const Case& c, const Plan& p) {
  const auto [smallest, largest] = std::minmax_element(p.radii.begin(), p.radii.end());
  const Vec3<double>& l = p.box.length;
  std::string text = "suspension\n";
  text += line("solid fraction", fmt::format("{:.4g}", p.solid_fraction));
  text += line("particles", fmt::format("{}", p.count()),
               fmt::format("diameters {:.4g} to {:.4g} d1", 2 * *smallest, 2 * *largest));
  text += line("box", fmt::format("{:.4g} x {:.4g} x {:.4g}", l.x, l.y, l.z), std::string(keyword(c.flow.boundary)));
  text += line("start", c.suspension.file ? c.suspension.file->text : fmt::format("seed {}", c.suspension.seed),
               c.suspension.file ? "" : "random packing");
  return text;
}

std::string model_lines(const Case& c, const Plan& p) {
  const ContactParameters& contact = p.physics.contact;
  std::string text = "model\n";
  text += line("Stokes number", fmt::format("{:.4g}", c.stokes_number()), "rho d1^2 gdot / eta");
  text += line("lubrication", p.physics.lubrication_law,
               fmt::format("gaps {:.3g} to {:.3g} d_eff{}", p.physics.cutoffs.inner, p.physics.cutoffs.outer,
                           p.resolved ? "; here for virtual_films alone" : ""));
  text += line("Stokes drag, stresslet",
               fmt::format("{}, {}", p.physics.drag ? "yes" : "no", p.physics.stresslet ? "yes" : "no"));
  text += line("contact", contact.normal_law,
               fmt::format("kn* = {:.4g}, kt/kn = {:.3g}{}", contact.stiffness, contact.tangential_ratio,
                           c.contact.largest_overlap ? ", from largest_overlap" : ""));
  text += line("friction", fmt::format("{:.3g}", contact.friction),
               c.contact.restitution < 1 ? fmt::format("restitution {:.3g}", c.contact.restitution) : "no dashpot");
  if (c.units) {
    const UnitsInput& u = *c.units;
    text += line(
        "SI", fmt::format("d1 {:.3g} m", u.diameter),
        fmt::format("1/gdot = {:.3g} s, stress unit eta gdot = {:.3g} Pa, kn = {:.3g} {}", 1 / u.shear_rate,
                    u.viscosity * u.shear_rate,
                    contact.stiffness * u.viscosity * u.shear_rate * (contact.normal_law == "hertz" ? 1.0 : u.diameter),
                    contact.normal_law == "hertz" ? "Pa" : "N/m"));
  }
  return text;
}

std::string time_lines(const Case& c, const Plan& p) {
  const StepBounds& b = p.bounds;
  std::string text = "time\n";
  text += line("scheme", p.time.scheme);
  const double step = p.time.substep();  // of the particles
  const std::string origin = p.resolved ? "of the lattice" : c.time.step ? "as given" : "derived";
  const std::string limit = fmt::format("; limit {:.3g}", b.largest);
  const bool divided = p.time.substeps > 1;
  text += line("step", fmt::format("{:.3g} / gdot", p.time.step), origin + (divided ? "" : limit));
  if (divided)
    text += line("particles' step", fmt::format("{:.3g} / gdot", step),
                 fmt::format("{} in a step of the lattice{}", p.time.substeps, limit));
  text += line("bound by", b.binding);
  if (b.contact > 0)
    text += line("half period of a contact", fmt::format("{:.3g} / gdot", b.contact),
                 fmt::format("{:.0f} steps", b.contact / step));
  if (b.film > 0)
    text +=
        line("relaxation of a film", fmt::format("{:.3g} / gdot", b.film), fmt::format("{:.2g} steps", b.film / step));
  if (b.relaxation > 0)
    text += line("relaxation of an overlap", fmt::format("{:.3g} / gdot", b.relaxation),
                 fmt::format("{:.0f} steps", b.relaxation / step));
  return text;
}

std::string cost_lines(const Case& c, const Plan& p) {
  std::string text = "run\n";
  text += line("strain", fmt::format("{:.4g}", c.run.strain),
               c.run.average_from ? fmt::format("averages from {:.4g}", *c.run.average_from)
                                  : "averages from the detected steady state");
  text += line("steps", fmt::format("{:.4g}", p.steps(c.run.strain)));
  text += line("threads", fmt::format("{}", p.threads));
  text += line("memory", memory_text(p.memory_bytes()));
  text +=
      line("expected time", duration_text(p.expected_seconds(c.run.strain)), "rough, see the progress line of the run");
  return text;
}

constexpr double fewest_diameters_across = 4;

std::string warnings(const Case& c, const Plan& p) {
  std::string text;
  const auto warn = [&](const std::string& message) { text += "  warning: " + message + "\n"; };
  if (c.stokes_number() > 0.3)
    warn("St > 0.3: particle inertia changes the viscosity (it no longer does below about 0.1)");
  if (p.time.scheme == "semi-implicit" && p.time.substep() > 2.5 * p.bounds.chosen)
    warn("the step is more than 2.5 times the default: expect errors of some per cent in the stress");
  if (p.count() < 500) warn("fewer than 500 particles: expect effects of the finite box beside a larger error bar");
  if (c.run.average_from && c.run.strain - *c.run.average_from < 2)
    warn("averages over less than 2 of strain: the error bar rests on few independent samples");
  const Vec3<double>& length = p.box.length;
  const double across = 2 * *std::max_element(p.radii.begin(), p.radii.end());
  const double diameters_across = std::min({length.x, length.y, length.z}) / across;
  if (diameters_across < fewest_diameters_across)
    warn(fmt::format("the box is {:.2g} of the largest diameters across: particles feel their own images below four",
                     diameters_across));
  if (!p.resolved && (c.resolution || c.flow.reynolds))
    warn("resolution and flow.reynolds have no effect: fidelity = \"lubricated\" has no lattice and no fluid inertia");
  if (p.physics.lubrication_law == "grand-resistance" && p.box.kind == BoxKind::walls)
    warn("films at the walls have no strain terms");
  if (p.resolved)
    for (const std::string& message :
         resolved_warnings(c, *p.resolved, *std::min_element(p.radii.begin(), p.radii.end())))
      warn(message);
  return text.empty() ? text : "warnings\n" + text;
}

}  // namespace

std::string plan_report(const Case& settled, const Plan& plan) {
  return suspension_lines(settled, plan) + model_lines(settled, plan) +
         (plan.resolved ? resolved_lines(settled, *plan.resolved) : "") + time_lines(settled, plan) +
         cost_lines(settled, plan) + warnings(settled, plan);
}

}  // namespace stresslet
