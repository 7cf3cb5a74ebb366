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
#include <functional>
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

class ResolvedFluid {
 public:
  /// `setup` as for Fluid, D3Q19; a body force takes Guo's form.
  static std::unique_ptr<ResolvedFluid> make(const FluidSetup& setup, const CouplingSetup& coupling);
  virtual ~ResolvedFluid() = default;

  virtual void initialise(ThreadTeam& team, const std::function<CellState(const Cells&)>& state) = 0;
  virtual Fluid::Totals totals(ThreadTeam& team) = 0;
  virtual std::vector<double> populations(ThreadTeam& team) = 0;
  virtual void restore(ThreadTeam& team, const std::vector<double>& populations, std::int64_t steps) = 0;
  virtual void set_shear_offset(double offset_lu) = 0;
  /// As the image above is displaced at the present time, after a step.
  virtual void follow_shear(double offset_lu) = 0;

  // All members of the team call these, in this order, once a step.
  virtual void prepare(Member& member, const std::vector<ResolvedSphere>& spheres) = 0;
  virtual void sweep(Member& member, const std::vector<ResolvedSphere>& spheres) = 0;

  /// After `prepare`: the sums over the cells of sphere `k`.
  const ExchangeSums& exchange(std::size_t k) const { return exchange_[k]; }
  /// After `prepare`: friction of spheres that share cells, one entry per pair of images, lumped at its centroid.
  const std::vector<PointFriction>& friction() const { return friction_; }

  /// Between steps: the energy of the fluid with `spheres` where the next step will have them. What `covered` says is
  /// then of these. `free`: of every plane of cells across y, from below.
  virtual FluidEnergy energy(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres,
                             std::vector<FreeFluid>& free) = 0;

  /// Between steps: momentum along x that fluid and solid, with the velocities of the last sweep, carried up through
  /// the sheared plane in the last step; between walls, what these passed on.
  virtual double momentum_across(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres) = 0;

 protected:
  std::vector<ExchangeSums> exchange_;
  std::vector<PointFriction> friction_;
};

/// Of one precision `T` of populations, solid drags and arithmetic in cells. Sums over spheres are taken in double
/// precision from runs of cells on; with single precision the momentum that fluid and spheres exchange balances to its
/// round-off, some 1e-7.
template <class T>
class ResolvedFluidOf final : public ResolvedFluid, private FluidOf<D3Q19, T> {
 public:
  using Stencil = D3Q19;
  using Base = FluidOf<Stencil, T>;

  ResolvedFluidOf(const FluidSetup& setup, const CouplingSetup& coupling);

  Lattice<Stencil, T>& lattice() { return lattice_; }
  /// After `prepare`, which cells the spheres cover.
  const CoveredRuns<T>& covered() const { return covered_; }

  void initialise(ThreadTeam& team, const std::function<CellState(const Cells&)>& state) override {
    Base::initialise(team, state);
  }
  Fluid::Totals totals(ThreadTeam& team) override { return Base::totals(team); }
  std::vector<double> populations(ThreadTeam& team) override { return Base::populations(team); }
  void restore(ThreadTeam& team, const std::vector<double>& all, std::int64_t steps) override {
    Base::restore(team, all, steps);
  }
  void set_shear_offset(double offset_lu) override { Base::set_shear_offset(offset_lu); }
  void follow_shear(double offset_lu) override { lattice_.shear_offset = offset_lu; }

  void prepare(Member& member, const std::vector<ResolvedSphere>& spheres) override;
  void sweep(Member& member, const std::vector<ResolvedSphere>& spheres) override;
  FluidEnergy energy(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres,
                     std::vector<FreeFluid>& free) override;
  double momentum_across(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres) override;

 private:
  using Base::boundaries_;
  using Base::lattice_;

  void find_friction(Member& member);
  void find_across();

  double velocity_difference_;  ///< across y: of the image above, or of the walls
  ResolvedSweep<Stencil, T> resolved_sweep_, forced_sweep_;
  RowEnergy<Stencil, T> row_energy_;
  CoveredRuns<T> covered_;
  ExchangeFactors factors_;
  SlotSums by_slot_;
  std::vector<std::vector<SharedRun>> shared_;           ///< by thread
  std::vector<std::vector<PointFriction>> friction_of_;  ///< by thread, each of its share of the images
  std::vector<ExchangeAcross> across_;
};

}  // namespace stresslet
