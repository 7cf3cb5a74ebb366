/// Two equal spheres in simple shear u = (gdot y, 0, 0), one above the other at a distance s a about the origin: free;
/// centres held, free to turn; held altogether. Exact values in unbounded fluid (recomputed; Jeffrey & Onishi, J. Fluid
/// Mech. 139 (1984) 261; Batchelor & Green, J. Fluid Mech. 56 (1972) 375, for free pairs). The thesis (Najuch,
/// University of Edinburgh 2018, chapter 3) holds the centres and compares with free pairs; both are given here.
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

struct Exact {
  double s;
  double free_velocity, free_spin, free_stresslet;  ///< U/(gdot a) of the upper sphere, Omega/gdot, S/S0
  double held_spin, held_stresslet;
  double fixed_force, fixed_stresslet;  ///< F/(6 pi eta a^2 gdot)
};

constexpr Exact table[] = {{3, 1.48329, 0.54287, 0.94765, 0.37014, 0.88651, 1.97307, 0.92790},
                           {4, 1.99475, 0.51882, 0.97023, 0.40213, 0.94681, 2.44803, 0.96550}};

UnboundedResult upper_sphere(Trial& trial, const ResolvedScheme& scheme, double radius, double s, Motion motion) {
  Unbounded setup{.scheme = scheme, .radius = radius, .shear_rate = 1};
  setup.speed = 2e-3 * scheme.viscosity();
  setup.spheres = {{.centre = {0, -s / 2, 0}, .motion = motion}, {.centre = {0, s / 2, 0}, .motion = motion}};
  return run_unbounded(trial, setup, fmt::format("A6, s = {}", s))[1];
}

}  // namespace

void pair_in_shear(Trial& trial) {
  const char* source = "two-sphere Stokes flow";
  const double bound = 0.03, radius = trial.choose(8, 5);
  trial.parameter("cells per diameter, default scheme", 2 * radius);
  for (const Exact& exact : table) {
    if (trial.quick() && exact.s != 3) continue;
    const std::string name = fmt::format("s = {}, ", exact.s);
    const UnboundedResult held = upper_sphere(trial, default_scheme(2), radius, exact.s, Motion::turning);
    trial.row(name + "centres held: angular velocity", -held.angular_velocity.z, {exact.held_spin, source},
              relative(bound));
    trial.row(name + "centres held: S/S0", 2 * held.stresslet.xy, {exact.held_stresslet, source}, relative(bound));
    trial.parameter(name + "S/S0 of a free pair (Batchelor & Green)", exact.free_stresslet);
    if (trial.quick()) continue;
    const UnboundedResult fixed = upper_sphere(trial, default_scheme(2), radius, exact.s, Motion::prescribed);
    trial.row(name + "held: force", fixed.force.x, {exact.fixed_force, source}, relative(bound));
    trial.row(name + "held: S/S0", 2 * fixed.stresslet.xy, {exact.fixed_stresslet, source}, relative(bound));
    const UnboundedResult free = upper_sphere(trial, default_scheme(2), radius, exact.s, Motion::free);
    trial.row(name + "free: velocity", free.velocity.x, {exact.free_velocity, source}, relative(bound));
    trial.row(name + "free: angular velocity", -free.angular_velocity.z, {exact.free_spin, source}, relative(bound));
    trial.row(name + "free: S/S0", 2 * free.stresslet.xy, {exact.free_stresslet, source}, relative(bound));
  }
  if (trial.quick()) return;
  for (const double tau : {0.7, 0.8, 1.1}) {
    const UnboundedResult r = upper_sphere(trial, thesis_scheme(tau), 5, 3, Motion::turning);
    const std::string name = fmt::format("superposition, tau {}, s = 3, centres held: S/S0", tau);
    if (tau == 0.7)
      trial.row(name, 2 * r.stresslet.xy, {table[0].held_stresslet, source}, relative(0.05));
    else
      trial.parameter(name, 2 * r.stresslet.xy);
  }
}

}  // namespace stresslet::validation
