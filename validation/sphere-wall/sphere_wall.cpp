/// One sphere above a plane wall, its centre at h: motion normal to the wall (exact series, Brenner, Chem. Eng. Sci. 16
/// (1961) 242; Maude 1961), along it, rotation, and held or free in the shear u = gdot y (O'Neill 1964; Goldman, Cox &
/// Brenner, Chem. Eng. Sci. 22 (1967) 637 and 653; recomputed), without correction of lubrication. Then motion normal
/// to the wall, along it, and rotation at gaps below a cell, with the calibrated correction.
#include "stresslet/coupling/subgrid/calibrated_lengths.hpp"
#include "validation/harness/unbounded.hpp"
#include "validation/harness/wall_calibration.hpp"

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

constexpr const char* recomputed = "Goldman, Cox & Brenner 1967, recomputed";

UnboundedResult above_wall(Trial& trial, double radius, double h, double shear_rate, const UnboundedSphere& sphere) {
  Unbounded setup{.scheme = default_scheme(2), .radius = radius, .shear_rate = shear_rate, .wall = -h};
  setup.spheres = {sphere};
  return run_unbounded(trial, setup, fmt::format("sphere and wall, h = {}", h))[0];
}

void rows_with_correction(Trial& trial) {
  const double radius = 5;
  const SubgridCorrection c = calibrated_correction("superposition", "viscosity-scaled", "TRT", 2);
  for (const WallMeasurement& m : measure_at_wall(trial, default_scheme(2), radius)) {
    const auto errors = corrected_errors(m, c.law, c.lengths_at_walls(), c.range);
    for (std::size_t k = 0; k < errors.size(); ++k)
      trial.row(
          fmt::format("gap of {} cells{}, corrected: {}", m.gap, m.shift == 0 ? "" : ", shifted", wall_motion_names[k]),
          (1 + errors[k]) * m.exact[k], {m.exact[k], k == 0 ? "Brenner 1961" : recomputed}, relative(0.05));
  }
}

}  // namespace

void sphere_wall(Trial& trial) {
  const double radius = trial.choose(8.0, 5.0), bound = 0.03;
  trial.parameter("cells per diameter", 2 * radius);
  for (const Exact& exact : table) {
    if (trial.quick() && exact.h != 2) continue;
    const double h = exact.h;
    const std::string name = fmt::format("h/a = {}: ", h);
    trial.row(name + "normal", above_wall(trial, radius, h, 0, {.velocity = {0, -1, 0}}).force.y,
              {exact.normal, "Brenner 1961"}, relative(bound));
    if (trial.quick()) continue;
    trial.row(name + "along", -above_wall(trial, radius, h, 0, {.velocity = {1, 0, 0}}).force.x,
              {exact.along, recomputed}, relative(bound));
    trial.row(name + "turning", -above_wall(trial, radius, h, 0, {.angular_velocity = {0, 0, 1}}).torque.z,
              {exact.turning, recomputed}, relative(bound));
    const UnboundedResult held = above_wall(trial, radius, h, 1, {});
    trial.row(name + "held in shear, force", held.force.x / h, {exact.held, recomputed}, relative(bound));
    trial.row(name + "held in shear, torque", -2 * held.torque.z, {exact.held_torque, recomputed}, relative(bound));
    const UnboundedResult free = above_wall(trial, radius, h, 1, {.motion = Motion::free});
    trial.row(name + "free in shear, velocity", free.velocity.x / h, {exact.free, recomputed}, relative(bound));
    trial.row(name + "free in shear, angular velocity", -2 * free.angular_velocity.z, {exact.free_spin, recomputed},
              relative(bound));
    trial.row(name + "free in shear, S/S0", 2 * free.stresslet.xy, {exact.free_stresslet, recomputed}, relative(bound));
  }
  if (!trial.quick()) rows_with_correction(trial);
}

}  // namespace stresslet::validation
