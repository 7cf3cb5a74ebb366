#pragma once
/// The resolved fluid of a suspension: lattice and particles in each other's units, and what passes between them in a
/// step.
///
/// Cell i is centred on (i + 1/2) dx. Units of the program (d1, 1/shear rate, viscosity 1) give the fluid the density
/// Re = rho d1^2 gdot / eta and the kinematic viscosity 1/Re, so that a step lasts nu_lu dx^2 Re.
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/subgrid/subgrid_links.hpp"
#include "stresslet/lubrication/fluid_coupling.hpp"
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"
#include "stresslet/rheology/stress.hpp"

namespace stresslet {

struct ResolvedSetup {
  Cells cells{};         ///< along the box; cells are cubes
  double cell = 0;       ///< their edge, d1
  double reynolds = 0;   ///< density of the fluid in units of the program
  CollisionInput rates;  ///< relaxation time and magic parameter
  std::string collision = "TRT";
  CouplingSetup coupling;
  std::optional<SubgridCorrection> correction;  ///< lengths in cells
  BoxKind box = BoxKind::lees_edwards;
  bool single_precision = false;  ///< of the fluid

  bool is_sheared() const { return box != BoxKind::periodic; }
  double cell_count() const { return double(cells[0]) * cells[1] * cells[2]; }
  double step() const { return kinematic_viscosity_lu(rates.relaxation_time) * cell * cell * reynolds; }
  /// Velocity between the faces across y: of the image above, or of the walls.
  double velocity_difference_lu() const { return is_sheared() ? cells[1] * step() : 0.0; }
  /// Of the fastest fluid of the mean flow, at the faces across y.
  double mach() const;
};

/// Momentum along x that spheres have carried up through the sheared plane with them, in the frame half-way between its
/// sides.
struct CarriedAcross {
  double momentum = 0;
  std::int64_t steps = 0;  ///< in as many steps
};

class ResolvedFlow {
 public:
  explicit ResolvedFlow(const ResolvedSetup& setup);

  /// The fluid at time zero: the mean shear flow, and inside the particles their motion.
  void fill(ThreadTeam& team, const ParticleState& state, const Box& box);

  // All members of the team, once a step each.
  /// Measures the fluid in the particles' cells and says what it does to them.
  void prepare(Member& member, const ParticleState& state, const Box& box, FluidCoupling& coupling);
  /// On one member, after particles have drifted for `step`: counts what those carried that crossed the faces, with the
  /// velocities that brought them there. After `prepare`, keeps to the frame in which the fluid met them.
  void note_crossings(const ParticleState& state, const Box& box, bool first, double step, FluidCoupling& coupling);
  /// Takes the particles' new velocities, which they keep for this share of the step.
  void follow(Member& member, const ParticleState& state, bool first, double share);
  /// Moves the fluid on, with the particles at the means of these.
  void sweep(Member& member) { fluid_->sweep(member, spheres_); }

  /// After `sweep`, per volume, in units of viscosity x shear rate: first moments of the forces that the particles
  /// exert on the fluid and on each other through shared cells, kinetic part included.
  Stress stresslet(const ParticleState& state, const Box& box, const FluidCoupling& coupling) const;
  /// The kinetic part of these alone.
  Stress kinetic_stresslet(const Box& box) const;

  /// Dissipation by the collisions of all cells, by the slip between solid and fluid, and by the friction in shared
  /// cells (coupling/fluid_energy.hpp); per volume, in units of viscosity x shear rate^2. Reads the whole lattice, once
  /// for this and `last_look`.
  double dissipation(ThreadTeam& team, const ParticleState& state, const Box& box, const FluidCoupling& coupling);
  /// What `dissipation` saw of the fluid besides, in lattice units.
  const FluidEnergy& last_look() const { return look_; }
  const std::vector<FreeFluid>& last_planes() const { return planes_; }
  /// Of the last look, per volume: first moment along y of the momentum of fluid and particles along x, less the mean
  /// flow. Its growth is what the stress through the sheared plane exceeds the mean stress by.
  double stored_momentum(const ParticleState& state, const Box& box) const;
  /// Adds the fluid's part of the last look to a sample: its Reynolds stress and kinetic energy.
  void add_to(Sample& sample) const;

  /// Force along x of the fluid, the solid and the friction above the sheared plane on those below, in the last
  /// step; between walls the mean of what they do to the fluid, upwards.
  double force_across_plane(ThreadTeam& team, const Box& box, const FluidCoupling& coupling,
                            const ParticleState& state);
  const CarriedAcross& carried() const { return carried_; }
  void set_carried(const CarriedAcross& carried) { carried_ = carried; }

  Fluid::Totals totals(ThreadTeam& team) { return fluid_->totals(team); }
  std::vector<double> populations(ThreadTeam& team) { return fluid_->populations(team); }
  void restore(ThreadTeam& team, const std::vector<double>& populations, std::int64_t steps, double offset);

  const ResolvedSetup& setup() const { return setup_; }

 private:
  Vec3<double> centre_lu(const ParticleState& state, std::size_t i) const;
  double energy_unit() const { return mass_unit_ * setup_.cell * setup_.cell / (step_ * step_); }

  ResolvedSetup setup_;
  double step_, mass_unit_;  ///< of the program, per unit of the lattice
  std::unique_ptr<ResolvedFluid> fluid_;
  std::vector<ResolvedSphere> spheres_;
  std::vector<double> frame_;  ///< what velocities of the particles along x have gained by crossing since `prepare`
  FluidEnergy look_;
  std::vector<FreeFluid> planes_;
  CarriedAcross carried_;
};

}  // namespace stresslet
