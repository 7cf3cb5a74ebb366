#pragma once
/// What the cases of resolved spheres have in common: schemes, spheres that are held, turn or move, steady states, and
/// readings of the flow. Lattice units; cell i is centred on coordinate i.
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/covered_cells.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"
#include "stresslet/coupling/subgrid/subgrid_links.hpp"
#include "validation/harness/trial.hpp"

namespace stresslet::validation {

/// Everything that a result may depend on besides the set-up.
struct ResolvedScheme {
  std::string collision, coupling_operator, fraction, weight;
  double relaxation_time;
  double magic_parameter = 1.0 / 12;  ///< of TRT

  double viscosity() const { return kinematic_viscosity_lu(relaxation_time); }
};
inline ResolvedScheme default_scheme(double relaxation_time = 1) {
  return {"TRT", "superposition", "plane-cut", "viscosity-scaled", relaxation_time};
}
/// BGK, sub-cells and linear weight: the scheme of published work.
inline ResolvedScheme thesis_scheme(double relaxation_time = 0.7,
                                    const std::string& coupling_operator = "superposition") {
  return {"BGK", coupling_operator, "sub-cells", "linear", relaxation_time};
}

FluidSetup resolved_box(const Cells& size, const ResolvedScheme& scheme);
/// Opens the faces across y to walls that move along x with -speed (low) and +speed (high); `law` as in FaceSetup.
void add_moving_walls(FluidSetup& setup, double speed_lu, const std::string& law);

enum class Motion {
  prescribed,  ///< velocities stay as they are
  turning,     ///< velocity stays, rotation is free
  free
};

struct TestSphere {
  ResolvedSphere sphere;
  Motion motion = Motion::prescribed;
  bool travels = false;     ///< whether the centre moves with the velocity; else the flow settles around it
  double density = 1;       ///< over that of the fluid at rest
  Vec3<double> force_lu{};  ///< on the sphere, besides the fluid's

  /// Less that of the fluid inside it, which moves with it.
  double own_mass_lu() const { return std::max(density - 1, 0.0) * 4 * pi / 3 * std::pow(sphere.radius, 3); }
};

/// First moment (F_x y + F_y x)/2 of the force on a sphere by where it acts: cells inside against cells at the surface;
/// and by quarters, F_x y/2 above and below the centre, F_y x/2 right (x > 0) and left.
struct MomentParts {
  double volume = 0, surface = 0;
  double quarter[4] = {};
};

class ResolvedFlow {
 public:
  ResolvedFlow(Trial& trial, const FluidSetup& setup, const ResolvedScheme& scheme, std::vector<TestSphere> spheres,
               std::string label);

  void fill(const std::function<CellState(const Cells&)>& state) { fluid_.initialise(trial_.team(), state); }
  void rest() {
    fill([](const Cells&) { return CellState{}; });
  }
  void set_force_density(const Vec3<double>& force_lu) { fluid_.lattice().input.force_density = force_lu; }
  /// Holds the images across a sheared boundary at this displacement.
  void freeze_shear(double offset_lu) { frozen_offset_ = offset_lu, frozen_ = true; }

  /// Between all pairs of spheres: the films that the grid does not resolve, and a spring where they overlap.
  void add_pair_forces(const SubgridCorrection& films, double spring_lu) { films_ = films, spring_ = spring_lu; }

  void advance(int steps);
  /// Advances until the loads and angular velocities change by less than `tolerance`, relative to the largest of each
  /// sphere, in the time `interval`. Throws NumericalFailure after `limit` steps.
  void advance_to_steady(double tolerance, int interval, int limit = 1000000);

  int steps() const { return steps_; }
  const TestSphere& sphere(std::size_t k = 0) const { return spheres_[k]; }
  TestSphere& sphere(std::size_t k = 0) { return spheres_[k]; }
  /// Of the last step, with the friction of spheres that share cells, without films and springs.
  const HydrodynamicLoad& load(std::size_t k = 0) const { return loads_[k]; }

  // Readings at the present time.
  MomentParts moment_parts(std::size_t k = 0);
  /// Mean velocity over all cells, of the incoming populations.
  Vec3<double> mean_velocity();
  /// Of fluid and spheres.
  Vec3<double> momentum();
  /// Velocity at a cell, with half of what the solids give in a step.
  Vec3<double> velocity(const Cells& cell);
  /// Mean shear stress xy in the plane between the rows y and y + 1, from the momentum that crosses it.
  double plane_stress(int y);

 private:
  void step(Member& member);
  void settle();
  void append_pair_forces(std::vector<SphereInertia>& inertia, std::vector<SphereLink>& links) const;
  CellPopulations<D3Q19, double> populations(const Cells& cell);
  void prepare();

  Trial& trial_;
  ResolvedScheme scheme_;
  std::string label_;
  std::vector<TestSphere> spheres_;
  std::vector<ResolvedSphere> solids_;  ///< as the fluid meets them
  SphereUpdate update_;
  std::vector<HydrodynamicLoad> loads_;
  ResolvedFluidOf<double> fluid_;
  std::optional<SubgridCorrection> films_;
  double spring_ = 0;
  int steps_ = 0;
  bool frozen_ = false;
  double frozen_offset_ = 0;
};

}  // namespace stresslet::validation
