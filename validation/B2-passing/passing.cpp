/// Two equal spheres that pass each other on parallel lines with +-U, at the moment when the line of centres stands
/// across (Najuch, PhD thesis, University of Edinburgh 2018, chapter 4): force YA11 + |YA12| along the line of flight,
/// torque of both motions, against exact two-sphere values where the thesis had asymptotes.
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

struct Exact {
  double s, force, torque;  ///< F/(6 pi eta a U), T/(8 pi eta a^2 U)
};

constexpr Exact table[] = {{2.2, 1.28804 + 0.54675, 0.5 * (0.26187 + 0.47073)},
                           {2.5, 1.16487 + 0.40108, 0.5 * (0.12415 + 0.29703)}};

}  // namespace

void passing(Trial& trial) {
  trial.parameter("cells per diameter", 10.0);
  for (const Exact& exact : table) {
    if (trial.quick() && exact.s != 2.5) continue;
    const auto run = [&](const ResolvedScheme& scheme) {
      Unbounded setup{.scheme = scheme, .speed = 2e-3 * scheme.viscosity()};
      setup.spheres = {{.centre = {0, -exact.s / 2, 0}, .velocity = {1, 0, 0}},
                       {.centre = {0, exact.s / 2, 0}, .velocity = {-1, 0, 0}}};
      return run_unbounded(trial, setup, fmt::format("B2, s = {}", exact.s))[0];
    };
    const std::string name = fmt::format("gap {:.1f} cells, ", 5 * (exact.s - 2));
    const UnboundedResult own = run(default_scheme(2));
    trial.row(name + "default: force", -own.force.x, {exact.force, "two-sphere Stokes flow"}, relative(0.03));
    trial.row(name + "default: torque", own.torque.z, {exact.torque, "two-sphere Stokes flow"}, relative(0.05));
    if (trial.quick()) continue;
    const UnboundedResult published = run(thesis_scheme(0.65));
    trial.parameter(name + "superposition, tau 0.65: force over exact", -published.force.x / exact.force);
    trial.parameter(name + "superposition, tau 0.65: torque over exact", published.torque.z / exact.torque);
  }
}

}  // namespace stresslet::validation
