/// Velocity along y through the centre of a free sphere in shear: u_x = gdot y (1 - a^5/(2 y^5)) outside, gdot y/2
/// inside (the sphere's rotation). Superposition is said to be the closer one outside, bounce-back inside (Najuch, PhD
/// thesis, University of Edinburgh 2018, chapter 3); the default scheme is judged.
#include <cmath>

#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

double exact_velocity(double y) { return y * (std::abs(y) > 1 ? 1 - 0.5 / std::pow(std::abs(y), 5) : 0.5); }

struct Errors {
  double inside, outside;  ///< root mean squares over gdot a; cells cut by the surface left out
};

Errors errors_of(const VelocityProfile& profile, double radius) {
  double inside = 0, outside = 0;
  int within = 0, beyond = 0;
  for (std::size_t k = 0; k < profile.height.size(); ++k) {
    const double y = profile.height[k], error = profile.velocity[k] - exact_velocity(y);
    if (std::abs(std::abs(y) - 1) < 0.75 / radius) continue;
    (std::abs(y) < 1 ? inside : outside) += error * error;
    ++(std::abs(y) < 1 ? within : beyond);
  }
  return {std::sqrt(inside / within), std::sqrt(outside / beyond)};
}

}  // namespace

void profiles(Trial& trial) {
  Table table{"profiles", {{"y", "a", "from the centre"}, {"exact", "gdot a", "velocity along the flow"}}, {{}, {}}};
  std::vector<std::pair<std::string, ResolvedScheme>> schemes{{"default", default_scheme(trial.choose(1.0, 2.0))}};
  if (!trial.quick()) {
    schemes.emplace_back("superposition", thesis_scheme(0.7));
    schemes.emplace_back("bounce-back", thesis_scheme(0.7, "bounce-back"));
  }
  std::vector<Errors> errors;
  for (const auto& [name, scheme] : schemes) {
    Unbounded setup{.scheme = scheme, .speed = 2e-3 * scheme.viscosity(), .shear_rate = 1};
    setup.spheres = {{.motion = Motion::turning}};
    VelocityProfile found;
    run_unbounded(trial, setup, "A5, " + name, trial.choose(1e-4, 5e-4), &found);
    if (table.values[0].empty()) {
      table.values[0] = found.height;
      for (const double y : found.height) table.values[1].push_back(exact_velocity(y));
    }
    table.columns.push_back({name, "gdot a", "velocity along the flow"});
    table.values.push_back(found.velocity);
    errors.push_back(errors_of(found, setup.radius));
    trial.parameter(name + ": error inside", errors.back().inside);
    trial.parameter(name + ": error outside", errors.back().outside);
  }
  trial.table(table);
  trial.row("default, inside: error over gdot a", errors[0].inside, {0, "rotation gdot/2"}, absolute(0.02));
  trial.row("default, outside: error over gdot a", errors[0].outside, {0, "Stokes"}, absolute(0.01));
}

}  // namespace stresslet::validation
