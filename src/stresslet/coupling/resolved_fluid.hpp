#pragma once
/// Fluid and spheres together: one step of the lattice with the spheres' cells in it.
///
///   map          which cells the spheres cover, and how firmly they hold the fluid there
///   gather       what the spheres must know of the fluid, per sphere
///   (the caller settles the spheres' velocities)
///   sweep        collide and stream, with the solid at these velocities
///
/// The momentum that the spheres take from the fluid in a step is load_on_sphere of `exchange(k)` with the velocities
/// of the sweep, to round-off the opposite of what the fluid is given; spheres that share cells besides rub against
/// each other (`friction`).
#include <memory>
#include <string>
#include <vector>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/coupling/exchange_sums.hpp"
#include "stresslet/coupling/fluid_energy.hpp"
#include "stresslet/coupling/resolved_sweep.hpp"
#include "stresslet/coupling/sheared_plane.hpp"
#include "stresslet/coupling/sphere_links.hpp"
#include "stresslet/lattice/fluid_of.hpp"
#include "stresslet/lattice/stencil/d3q19.hpp"

namespace stresslet {

struct CouplingSetup {
  std::string coupling_operator = "superposition";
  SolidLaws solid;  ///< its relaxation time is that of the fluid
};

class ResolvedFluid : private FluidOf<D3Q19, double> {
 public:
  using Stencil = D3Q19;

  /// `setup` as for Fluid, D3Q19 in double precision; a body force takes Guo's form.
  ResolvedFluid(const FluidSetup& setup, const CouplingSetup& coupling);

  Lattice<Stencil, double>& lattice() { return lattice_; }

  using FluidOf::bytes;
  using FluidOf::initialise;
  using FluidOf::measure;
  using FluidOf::populations;
  using FluidOf::restore;
  using FluidOf::set_shear_offset;
  using FluidOf::totals;

  // All members of the team call these, in this order, once a step.
  void prepare(Member& member, const std::vector<ResolvedSphere>& spheres);
  void sweep(Member& member, const std::vector<ResolvedSphere>& spheres);

  /// After `prepare`: the sums over the cells of sphere `k`.
  const ExchangeSums& exchange(std::size_t k) const { return exchange_[k]; }
  /// After `prepare`: friction of spheres that share cells, one entry per pair of images, lumped at its centroid.
  const std::vector<PointFriction>& friction() const { return friction_; }

  /// After `prepare`: which cells the spheres cover.
  const CoveredRuns& covered() const { return covered_; }

  /// Between steps: the energy of the fluid with `spheres` where the next step will have them. What `covered` says is
  /// then of these. `free`: of every plane of cells across y, from below.
  FluidEnergy energy(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres, std::vector<FreeFluid>& free);

  /// Between steps: momentum along x that fluid and solid, with the velocities of the last sweep, carried up through
  /// the sheared plane in the last step; between walls, what these passed on.
  double momentum_across(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres);

 private:
  void find_friction();
  void find_across();

  double velocity_difference_;  ///< across y: of the image above, or of the walls
  ResolvedSweep<Stencil> resolved_sweep_, forced_sweep_;
  RowEnergy<Stencil> row_energy_;
  CoveredRuns covered_;
  ExchangeFactors factors_;
  SlotSums by_slot_;
  std::vector<ExchangeSums> exchange_;
  std::vector<std::vector<SharedRun>> shared_;  ///< by thread
  std::vector<PointFriction> friction_;
  std::vector<ExchangeAcross> across_;
};

}  // namespace stresslet
