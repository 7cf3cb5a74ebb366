/// One sphere above a plane wall, its centre at h: motion normal to the wall (exact series, Brenner, Chem. Eng. Sci. 16
/// (1961) 242; Maude 1961), along it, rotation, and held or free in the shear u = gdot y (O'Neill 1964; Goldman, Cox &
/// Brenner, Chem. Eng. Sci. 22 (1967) 637 and 653; recomputed), without correction of lubrication. Then motion normal
/// to the wall and along it at gaps below a cell, with the correction that was calibrated between spheres.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/subgrid/calibrated_lengths.hpp"
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

struct Exact {
  double h;                                ///< over a
  double normal;                           ///< F/(6 pi eta a U)
  double along;                            ///< F/(6 pi eta a U)
  double turning;                          ///< T/(8 pi eta a^3 Omega)
  double held, held_torque;                ///< F/(6 pi eta a gdot h), T/(4 pi eta a^3 gdot)
  double free, free_spin, free_stresslet;  ///< U/(gdot h), Omega/(gdot/2), S/S0
};

constexpr Exact table[] = {{1.543081, 3.036064, 1.56746, 1.09980, 1.43915, 0.97423, 0.92187, 0.92371, 1.2122},
                           {2, 2.125536, 1.38275, 1.04178, 1.33152, 0.98542, 0.96412, 0.96450, 1.1009},
                           {3.762196, 1.412874, 1.17381, 1.00592, 1.16711, 0.99710, 0.99436, 0.99436, 1.0166}};

UnboundedResult above_wall(Trial& trial, double radius, double h, double shear_rate, const UnboundedSphere& sphere) {
  Unbounded setup{.scheme = default_scheme(2), .radius = radius, .shear_rate = shear_rate, .wall = -h};
  setup.spheres = {sphere};
  return run_unbounded(trial, setup, fmt::format("sphere and wall, h = {}", h))[0];
}

/// Brenner (1961): F/(6 pi eta a U) of a sphere that moves towards the wall, its centre at a cosh(alpha).
double exact_approach(double gap_over_radius) {
  const double alpha = std::acosh(1 + gap_over_radius);
  double sum = 0;
  for (int n = 1; n < 2000; ++n) {
    const double k = 2 * n + 1, half = std::sinh(0.5 * k * alpha);
    if (k * alpha > 600) break;
    const double term = (2 * std::sinh(k * alpha) + k * std::sinh(2 * alpha)) /
                            (4 * half * half - k * k * std::sinh(alpha) * std::sinh(alpha)) -
                        1;
    sum += n * (n + 1.0) / ((2 * n - 1.0) * (2 * n + 3.0)) * term;
  }
  return 4.0 / 3 * std::sinh(alpha) * sum;
}

/// Goldman, Cox & Brenner (1967): the same along the wall, for gaps small against the radius.
double exact_sliding(double gap_over_radius) { return -8.0 / 15 * std::log(gap_over_radius) + 0.9588; }

void rows_with_correction(Trial& trial) {
  const double radius = 5;
  const SubgridCorrection correction = calibrated_correction("superposition", "viscosity-scaled", "TRT", 2);
  for (const double gap : {1.0, 0.5, 0.2}) {
    const PairResistance<double> film =
        subgrid_wall_resistance<SoftCutOff>(radius, gap, correction.lengths, correction.range);
    const double h = 1 + gap / radius, unit = 6 * pi * radius;
    const std::string name = fmt::format("gap of {} cells, corrected: ", gap);
    trial.row(name + "normal", above_wall(trial, radius, h, 0, {.velocity = {0, -1, 0}}).force.y + film.X / unit,
              {exact_approach(gap / radius), "Brenner 1961"}, relative(0.05));
    if (gap < 0.5)
      trial.row(name + "along", -above_wall(trial, radius, h, 0, {.velocity = {1, 0, 0}}).force.x + film.Y / unit,
                {exact_sliding(gap / radius), "Goldman, Cox & Brenner 1967"}, relative(0.05));
  }
}

}  // namespace

void sphere_wall(Trial& trial) {
  const double radius = trial.choose(8.0, 5.0), bound = 0.03;
  trial.parameter("cells per diameter", 2 * radius);
  const char* source = "Goldman, Cox & Brenner 1967, recomputed";
  for (const Exact& exact : table) {
    if (trial.quick() && exact.h != 2) continue;
    const double h = exact.h;
    const std::string name = fmt::format("h/a = {}: ", h);
    trial.row(name + "normal", above_wall(trial, radius, h, 0, {.velocity = {0, -1, 0}}).force.y,
              {exact.normal, "Brenner 1961"}, relative(bound));
    if (trial.quick()) continue;
    trial.row(name + "along", -above_wall(trial, radius, h, 0, {.velocity = {1, 0, 0}}).force.x, {exact.along, source},
              relative(bound));
    trial.row(name + "turning", -above_wall(trial, radius, h, 0, {.angular_velocity = {0, 0, 1}}).torque.z,
              {exact.turning, source}, relative(bound));
    const UnboundedResult held = above_wall(trial, radius, h, 1, {});
    trial.row(name + "held in shear, force", held.force.x / h, {exact.held, source}, relative(bound));
    trial.row(name + "held in shear, torque", -2 * held.torque.z, {exact.held_torque, source}, relative(bound));
    const UnboundedResult free = above_wall(trial, radius, h, 1, {.motion = Motion::free});
    trial.row(name + "free in shear, velocity", free.velocity.x / h, {exact.free, source}, relative(bound));
    trial.row(name + "free in shear, angular velocity", -2 * free.angular_velocity.z, {exact.free_spin, source},
              relative(bound));
    trial.row(name + "free in shear, S/S0", 2 * free.stresslet.xy, {exact.free_stresslet, source}, relative(bound));
  }
  if (!trial.quick()) rows_with_correction(trial);
}

}  // namespace stresslet::validation
