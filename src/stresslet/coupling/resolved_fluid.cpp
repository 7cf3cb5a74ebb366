#include "stresslet/coupling/resolved_fluid.hpp"

#include <algorithm>
#include <map>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/lattice/boundary/make_boundaries.hpp"
#include "stresslet/lattice/cell_state.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

ResolvedFluid::ResolvedFluid(const FluidSetup& setup, const CouplingSetup& coupling)
    : lattice_(setup.grid),
      boundaries_(make_boundaries<Stencil, double>(setup)),
      sweep_(resolved_sweep_for<Stencil>(setup.collision, coupling.coupling_operator)),
      solid_(coupling.solid),
      covered_(setup.grid) {
  CollisionLaws::dispatch(setup.collision,
                          [&](auto c) { lattice_.input.rates = decltype(c)::type::rates(setup.rates); });
  CouplingOperators::dispatch(coupling.coupling_operator, [&](auto law) {
    using Law = typename decltype(law)::type;
    factors_ = {Law::exchange, Law::kinetic_stress_factor};
  });
  lattice_.shear_velocity = setup.shear_velocity_lu;
  solid_.relaxation_time = setup.rates.relaxation_time;
}

void ResolvedFluid::fill(const std::function<CellState(const Cells&)>& state) {
  const BodyForce<double> force{lattice_.input.force_density, lattice_.input.rates.odd};
  for (auto& block : lattice_.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const Cells& n = layout.size();
    for (int z = 0; z < n[2]; ++z)
      for (int y = 0; y < n[1]; ++y)
        for (int x = 0; x < n[0]; ++x) {
          const auto f = populations_of<Stencil>(state({block.origin[0] + x, block.origin[1] + y, block.origin[2] + z}),
                                                 lattice_.input.rates, force);
          for (int i = 0; i < Stencil::size; ++i) block.populations.slot(i)[layout.index(x, y, z)] = f[std::size_t(i)];
        }
  }
  for (const auto& boundary : boundaries_) boundary->initialise(lattice_);
}

void ResolvedFluid::prepare(Member& member, const std::vector<ResolvedSphere>& spheres) {
  prepare_step(lattice_, boundaries_, member);
  replace_populations(lattice_, boundaries_, member);
  covered_.map(member, solid_, spheres, lattice_.shear_offset, lattice_.shear_velocity);
  if (member.rank() == 0) {
    run_sums_.resize(covered_.runs().size());
    exchange_.resize(spheres.size());
    shared_.resize(std::size_t(member.size()));
  }
  member.barrier();
  const Range runs = member.share(covered_.runs().size());
  std::vector<SharedRun>& shared = shared_[std::size_t(member.rank())];
  shared.clear();
  gather_exchange<Stencil>(lattice_, covered_, factors_, runs.begin, runs.end, run_sums_.data(), shared);
  member.barrier();
  const Range mine = member.share(spheres.size());
  for (std::size_t k = mine.begin; k < mine.end; ++k) {
    ExchangeSums<double> sum;
    const Range images = covered_.images_of_sphere(k);
    for (std::size_t i = images.begin; i < images.end; ++i)
      for (std::size_t run = covered_.runs_of_image(i).begin; run < covered_.runs_of_image(i).end; ++run)
        sum += run_sums_[run];
    exchange_[k] = sum;
  }
  if (member.rank() == 0) find_friction();
  member.barrier();
}

/// Runs come in the same order whatever the number of threads, and so do the sums.
void ResolvedFluid::find_friction() {
  std::map<std::pair<std::int32_t, std::int32_t>, SharedRun> sums;
  for (const auto& of_thread : shared_)
    for (const SharedRun& s : of_thread) {
      SharedRun& sum = sums.try_emplace({s.first, s.second}, SharedRun{s.first, s.second}).first->second;
      sum.coefficient += s.coefficient;
      sum.coefficient_arm += s.coefficient_arm;
    }
  friction_.clear();
  for (const auto& [images, s] : sums) {
    const SphereImage &first = covered_.images()[std::size_t(s.first)],
                      &second = covered_.images()[std::size_t(s.second)];
    const Vec3<double> arm = s.coefficient_arm / s.coefficient;
    friction_.push_back({first.sphere,
                         second.sphere,
                         s.coefficient,
                         arm,
                         arm + first.centre - second.centre,
                         {second.velocity_jump - first.velocity_jump, 0, 0}});
  }
}

void ResolvedFluid::sweep(Member& member, const std::vector<ResolvedSphere>& spheres) {
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
    sweep_(lattice_, int(b), covered_, spheres, rows.begin, rows.end);
  }
  finish_step(lattice_, boundaries_, member);
}

Moments<double> ResolvedFluid::totals(ThreadTeam& team) {
  team.run([&](Member& member) { prepare_step(lattice_, boundaries_, member); });
  Moments<double> sum{};
  for (const auto& block : lattice_.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const Cells& n = layout.size();
    for (int z = 0; z < n[2]; ++z)
      for (int y = 0; y < n[1]; ++y)
        for (int x = 0; x < n[0]; ++x) {
          const auto m = moments_of(incoming(block.populations, lattice_.arrangement, layout.index(x, y, z)));
          sum.density_deviation += m.density_deviation;
          sum.momentum += m.momentum;
        }
  }
  return sum;
}

}  // namespace stresslet
