#include "stresslet/simulation/resolved/resolved_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/base/error.hpp"
#include "stresslet/coupling/operators/holdych.hpp"
#include "stresslet/coupling/subgrid/calibrated_lengths.hpp"
#include "stresslet/coupling/weight_choice.hpp"
#include "stresslet/exec/huge_array.hpp"
#include "stresslet/lubrication/normal_only.hpp"
#include "stresslet/simulation/case_refusals.hpp"
#include "stresslet/simulation/progress.hpp"
#include "stresslet/simulation/report_lines.hpp"

namespace stresslet {

namespace {

constexpr double fewest_cells_across = 2, advised_cells_across = 4;

std::optional<SubgridCorrection> correction_of(const Case& c) {
  const ResolutionInput& r = *c.resolution;
  const std::string_view films = c.switches().lubrication;
  if (*r.correction == no_correction || films == "none") return std::nullopt;
  SubgridCorrection correction;
  correction.law = *r.correction;
  if (r.correction_lengths) {
    const std::vector<double>& l = *r.correction_lengths;
    correction.lengths = {l[0], l[1], l[2]};
  } else {
    try {
      correction = calibrated_correction(*r.coupling, *r.solid_weight, *r.collision, *r.relaxation_time, *r.correction);
    } catch (const InputError& error) {
      throw InputError({c.where("resolution.correction"), error.what(), "", ""});
    }
  }
  if (films == NormalOnly::name) {
    correction.lengths = {correction.lengths.normal, 0, 0};
    correction.wall_lengths = SubgridLengths{correction.lengths_at_walls().normal, 0, 0};
  }
  return correction;
}

void check_flow(const Case& c, const ResolvedSetup& s) {
  const ResolutionInput& r = *c.resolution;
  if (s.mach() <= r.largest_mach) return;
  const double factor = r.largest_mach / s.mach();
  refuse(c.where("resolution.relaxation_time"),
         fmt::format("the Mach number of the mean flow would be {:.3g}, above the largest allowed one, {:.3g}",
                     s.mach(), r.largest_mach),
         fmt::format("Re = {:.4g}, relaxation time {:.4g} and {:.3g} cells per diameter fix it; the fluid would be "
                     "compressed",
                     s.reynolds, s.rates.relaxation_time, 1 / s.cell),
         fmt::format("nearest possible: resolution.relaxation_time = {:.3g}, or flow.reynolds = {:.3g}, or "
                     "resolution.cells_per_diameter = {:.0f}",
                     0.5 + factor * (s.rates.relaxation_time - 0.5), factor * s.reynolds,
                     std::ceil(1 / (s.cell * factor))));
}

}  // namespace

Cells cells_along(const Vec3<double>& box_length, double cells_per_diameter) {
  const auto whole = [&](double length) { return std::max(1, int(std::lround(length * cells_per_diameter))); };
  return {whole(box_length.x), whole(box_length.y), whole(box_length.z)};
}

ResolvedSetup resolved_setup(const Case& c, const Box& box, double smallest_radius) {
  const ResolutionInput& r = *c.resolution;
  ResolvedSetup s;
  s.cells = cells_along(box.length, *r.cells_per_diameter);
  s.cell = box.length.x / s.cells[0];
  for (const auto& [length, cells] : {std::pair{box.length.y, s.cells[1]}, std::pair{box.length.z, s.cells[2]}})
    if (std::abs(length - cells * s.cell) > 1e-6 * length)
      refuse(c.where("suspension.file"),
             fmt::format("a box of {:.6g} x {:.6g} x {:.6g} is no whole number of cubic cells", box.length.x,
                         box.length.y, box.length.z),
             fmt::format("with {} cells along x, the cells have an edge of {:.6g} d1", s.cells[0], s.cell),
             "choose another resolution.cells_per_diameter, or another box");
  s.reynolds = c.reynolds_number();
  s.rates.relaxation_time = *r.relaxation_time;
  s.rates.magic_parameter = *r.magic_parameter;
  s.collision = *r.collision;
  s.single_precision = *r.precision == Precision::floating32;
  s.coupling.coupling_operator = *r.coupling;
  s.coupling.solid.fraction = *r.solid_fraction;
  s.coupling.solid.weight = *r.solid_weight;
  s.box = box.kind;
  require_borne(*r.coupling, *r.solid_weight, c.where("resolution.solid_weight"),
                "take resolution.solid_weight = \"noble-torczynski\" or \"linear\", or resolution.coupling = "
                "\"superposition\"");
  if (*std::max_element(s.cells.begin(), s.cells.end()) > most_cells_along)
    refuse(c.where("resolution.cells_per_diameter"),
           fmt::format("the lattice would have {} x {} x {} cells", s.cells[0], s.cells[1], s.cells[2]),
           fmt::format("along an axis there may be {} with spheres in the fluid", most_cells_along),
           "take fewer cells per diameter, or a box with another aspect");
  s.correction = correction_of(c);

  if (2 * smallest_radius / s.cell < fewest_cells_across)
    refuse(c.where("resolution.cells_per_diameter"),
           fmt::format("the smallest particle would be {:.2g} cells across", 2 * smallest_radius / s.cell),
           "below 2 cells a particle is no sphere any more",
           fmt::format("give at least resolution.cells_per_diameter = {:.0f}",
                       std::ceil(fewest_cells_across / (2 * smallest_radius))));
  check_flow(c, s);
  const double bytes = resolved_bytes(s), there = double(physical_memory());
  if (there > 0 && bytes > there)
    refuse(c.where("resolution.cells_per_diameter"),
           fmt::format("the lattice needs {}, and this machine has {}", memory_text(bytes), memory_text(there)),
           fmt::format("it has {} x {} x {} cells", s.cells[0], s.cells[1], s.cells[2]),
           "take fewer particles or fewer cells per diameter");
  return s;
}

double resolved_bytes(const ResolvedSetup& s) {
  return 20.0 * double(s.single_precision ? sizeof(float) : sizeof(double)) * (s.cells[0] + 2) * (s.cells[1] + 2) *
         (s.cells[2] + 2);
}

std::string resolved_lines(const Case& c, const ResolvedSetup& s) {
  const ResolutionInput& r = *c.resolution;
  std::string text = "resolved fluid\n";
  text += line("Reynolds number", fmt::format("{:.4g}", s.reynolds), "rho d1^2 gdot / eta");
  text += line("lattice", fmt::format("{} x {} x {}", s.cells[0], s.cells[1], s.cells[2]),
               fmt::format("{:.4g} cells per d1, {}", 1 / s.cell, keyword(*r.precision)));
  text += line("relaxation time", fmt::format("{:.4g}", s.rates.relaxation_time),
               fmt::format("{}, preset {}", s.collision, keyword(r.preset)));
  text += line("step", fmt::format("{:.3g} / gdot", s.step()), "strain per step, nu_lu dx^2 Re");
  text += line("Mach number", fmt::format("{:.3g}", s.mach()), "of the mean flow at the faces");
  text += line("solid", s.coupling.coupling_operator,
               fmt::format("{}, weight {}", s.coupling.solid.fraction, s.coupling.solid.weight));
  if (!s.correction) return text + line("correction", "none");
  const auto lengths = [](const SubgridLengths& l) {
    return fmt::format("normal {:.3g}, sliding {:.3g}, spin {:.3g} cells", l.normal, l.sliding, l.spin);
  };
  text += line("correction", s.correction->law, lengths(s.correction->lengths));
  if (s.box == BoxKind::walls) text += line("at walls", s.correction->law, lengths(s.correction->lengths_at_walls()));
  return text;
}

std::vector<std::string> resolved_warnings(const Case& c, const ResolvedSetup& s, double smallest_radius) {
  std::vector<std::string> found;
  const double across = 2 * smallest_radius / s.cell, density_ratio = c.stokes_number() / s.reynolds;
  if (across < advised_cells_across)
    found.push_back(
        fmt::format("the smallest particle is {:.2g} cells across: expect errors of 10 % and more", across));
  else if (across < 8)
    found.push_back(fmt::format(
        "the smallest particle is {:.2g} cells across: drag errs by 0.6 % at 8, 1 % at 6, 4 % at 4, torque by "
        "2.5, 4.5 and 10 %",
        across));
  constexpr double round_off = 1e-9;
  if (density_ratio > 100 * (1 + round_off))
    found.push_back(fmt::format(
        "density ratio {:.3g} lies outside the verified range, 0.1 to 100: steady motion does not depend on it, "
        "and of the inertia less than a hundredth is the fluid's",
        density_ratio));
  if (density_ratio < 1 - round_off)
    found.push_back(fmt::format(
        "density ratio {:.3g}{}: in unsteady motion spheres have the inertia of the fluid inside "
        "them, with that of the fluid around {:.2g} times what they should",
        density_ratio, density_ratio < 0.1 * (1 - round_off) ? ", outside the verified range of 0.1 to 100" : "",
        1.5 / (density_ratio + 0.5)));
  if (s.rates.relaxation_time < 0.55 || s.rates.relaxation_time > 2)
    found.push_back(
        fmt::format("relaxation time {:.3g} lies outside the verified range, 0.55 to 2", s.rates.relaxation_time));
  if (s.coupling.coupling_operator == Holdych::name)
    found.emplace_back(
        "holdych reflects the momentum of solid cells and does not damp it: in spheres that move, disturbances grow "
        "and "
        "end the run within a strain of 1 or 2; half-holdych does not");
  if (s.rates.relaxation_time > 1.5 && s.reynolds > 0.02)
    found.emplace_back(
        "relaxation time above 1.5 at Re > 0.02: compressed fluid reads the viscosity some per cent low");
  if (!s.correction) found.emplace_back("films below one cell are not corrected: the viscosity falls short");
  return found;
}

}  // namespace stresslet
