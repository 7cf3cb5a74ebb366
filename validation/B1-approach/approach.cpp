/// Two equal spheres that approach each other along their line of centres, at a gap of one cell (Najuch, PhD thesis,
/// University of Edinburgh 2018, chapter 4): force over 6 pi eta a U against the exact series, U the speed of each. The
/// thesis's scheme falls short or overshoots with the relaxation time; the numbers to meet are those of an independent
/// program in a periodic box. The flow settles around spheres that stay where they are.
#include <cmath>

#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

double relative_force(Trial& trial, const ResolvedScheme& scheme, const Vec3<double>& direction, double s,
                      double exact) {
  Unbounded setup{.scheme = scheme, .speed = 2e-3 * scheme.viscosity()};
  const Vec3<double> force = (6 * pi * exact) * direction;
  setup.spheres = {{.centre = (-s / 2) * direction, .velocity = direction, .force = force},
                   {.centre = (s / 2) * direction, .velocity = -direction, .force = -force}};
  const auto r = run_unbounded(trial, setup, fmt::format("B1, tau {}", scheme.relaxation_time));
  return -dot(r[0].force, direction) / exact;
}

}  // namespace

void approach(Trial& trial) {
  const Vec3<double> aligned{0, 1, 0}, diagonal = (1 / std::sqrt(3.0)) * Vec3<double>{1, 1, 1};
  const double exact = 4.62554, s = 2.2;
  trial.parameter("cells per diameter", 10.0);
  trial.parameter("gap, cells", 1.0);
  if (trial.quick()) {
    // Without correction the default scheme is within some per cent from a gap of 2.5 cells on.
    trial.row("default scheme, gap 2.5 cells: force over exact",
              relative_force(trial, default_scheme(2), aligned, 2.5, 2.77242), {1, "exact series"}, relative(0.03));
    return;
  }
  const std::pair<double, double> published[] = {{0.65, 0.965}, {0.7, 0.90}, {0.9, 0.73}, {1.1, 0.65}, {1.3, 0.59}};
  Table scan{"relaxation-time",
             {{"tau", "", ""}, {"force", "exact", "at a gap of one cell"}, {"independent", "exact", "the same scheme"}},
             std::vector<std::vector<double>>(3)};
  for (const auto& [tau, expected] : published) {
    const double found = relative_force(trial, thesis_scheme(tau), aligned, s, exact);
    trial.row(fmt::format("superposition, tau {}: force over exact", tau), found, {expected, "independent program"},
              absolute(0.03));
    scan.values[0].push_back(tau);
    scan.values[1].push_back(found);
    scan.values[2].push_back(expected);
  }
  trial.table(scan);
  trial.parameter("superposition, tau 0.65, along the diagonal",
                  relative_force(trial, thesis_scheme(0.65), diagonal, s, exact));
  trial.parameter("default scheme, aligned", relative_force(trial, default_scheme(2), aligned, s, exact));
  trial.parameter("default scheme, along the diagonal", relative_force(trial, default_scheme(2), diagonal, s, exact));
}

}  // namespace stresslet::validation
