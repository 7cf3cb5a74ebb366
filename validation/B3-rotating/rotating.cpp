/// Two equal spheres, centres held, that turn with the same angular velocity about an axis across their line of centres
/// (Najuch, PhD thesis, University of Edinburgh 2018, chapter 4): torque YC11 + YC12, and the force by reciprocity that
/// of the torque of B2. Exact two-sphere values; the thesis's asymptotes do not hold at these gaps.
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

struct Exact {
  double s, force, torque;  ///< F/(6 pi eta a^2 Omega), T/(8 pi eta a^3 Omega)
};

constexpr Exact table[] = {{2.2, 2.0 / 3 * (0.26187 + 0.47073), 1.13981 + 0.07426},
                           {2.5, 2.0 / 3 * (0.12415 + 0.29703), 1.05274 + 0.04172}};

}  // namespace

void rotating(Trial& trial) {
  trial.parameter("cells per diameter", 10.0);
  for (const Exact& exact : table) {
    if (trial.quick() && exact.s != 2.5) continue;
    const auto run = [&](const ResolvedScheme& scheme) {
      Unbounded setup{.scheme = scheme, .speed = 2e-3 * scheme.viscosity()};
      setup.spheres = {{.centre = {0, -exact.s / 2, 0}, .angular_velocity = {0, 0, 1}},
                       {.centre = {0, exact.s / 2, 0}, .angular_velocity = {0, 0, 1}}};
      return run_unbounded(trial, setup, fmt::format("B3, s = {}", exact.s))[0];
    };
    const std::string name = fmt::format("gap {:.1f} cells, ", 5 * (exact.s - 2));
    const UnboundedResult own = run(default_scheme(2));
    trial.row(name + "default: force", own.force.x, {exact.force, "two-sphere Stokes flow"}, relative(0.05));
    trial.row(name + "default: torque", -own.torque.z, {exact.torque, "two-sphere Stokes flow"}, relative(0.03));
    if (trial.quick()) continue;
    const UnboundedResult published = run(thesis_scheme(0.65));
    trial.parameter(name + "superposition, tau 0.65: force over exact", published.force.x / exact.force);
    trial.parameter(name + "superposition, tau 0.65: torque over exact", -published.torque.z / exact.torque);
  }
}

}  // namespace stresslet::validation
