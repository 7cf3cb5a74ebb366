#include "stresslet/coupling/resolved_fluid.hpp"

#include <algorithm>
#include <tuple>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/lattice/boundary/make_boundaries.hpp"
#include "stresslet/lattice/cell_state.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

ResolvedFluid::ResolvedFluid(const FluidSetup& setup, const CouplingSetup& coupling)
    : lattice_(setup.grid),
      boundaries_(make_boundaries<Stencil, double>(setup)),
      sweep_(resolved_sweep_for<Stencil>(setup.collision, coupling.coupling_operator, false)),
      forced_sweep_(resolved_sweep_for<Stencil>(setup.collision, coupling.coupling_operator, true)),
      covered_(setup.grid, {coupling.solid.fraction, coupling.solid.weight, setup.rates.relaxation_time}) {
  CollisionLaws::dispatch(setup.collision,
                          [&](auto c) { lattice_.input.rates = decltype(c)::type::rates(setup.rates); });
  CouplingOperators::dispatch(coupling.coupling_operator, [&](auto law) {
    using Law = typename decltype(law)::type;
    factors_ = {Law::exchange, Law::kinetic_stress_factor};
  });
  lattice_.shear_velocity = setup.shear_velocity_lu;
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
  covered_.place(member, spheres, lattice_.shear_offset, lattice_.shear_velocity);
  if (member.rank() == 0) {
    by_slot_.resize(covered_.runs().size());
    exchange_.resize(spheres.size());
    shared_.resize(std::size_t(member.size()));
  }
  member.barrier();
  std::vector<SharedRun>& shared = shared_[std::size_t(member.rank())];
  shared.clear();
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
    if (rows.begin < rows.end)
      gather_exchange<Stencil>(lattice_, int(b), covered_, factors_, rows.begin, rows.end, by_slot_.data(), shared);
  }
  member.barrier();
  const Range mine = member.share(spheres.size());
  for (std::size_t k = mine.begin; k < mine.end; ++k) {
    ExchangeSums sum;
    const Range images = covered_.images_of_sphere(k);
    for (std::size_t i = images.begin; i < images.end; ++i)
      for (std::size_t slot = covered_.slots_of_image(i).begin; slot < covered_.slots_of_image(i).end; ++slot)
        by_slot_[slot].add_to(sum);
    exchange_[k] = sum;
  }
  if (member.rank() == 0) find_friction();
  member.barrier();
}

/// Summed in the order of slots, whatever the division of the work.
void ResolvedFluid::find_friction() {
  std::vector<SharedRun> all;
  for (const auto& of_thread : shared_) all.insert(all.end(), of_thread.begin(), of_thread.end());
  std::sort(all.begin(), all.end(), [](const SharedRun& a, const SharedRun& b) {
    return std::tie(a.first, a.second, a.slot) < std::tie(b.first, b.second, b.slot);
  });
  friction_.clear();
  for (auto group = all.begin(); group != all.end();) {
    SharedRun sum{0, group->first, group->second};
    for (; group != all.end() && group->first == sum.first && group->second == sum.second; ++group) {
      sum.coefficient += group->coefficient;
      sum.coefficient_arm += group->coefficient_arm;
    }
    const SphereImage &first = covered_.images()[std::size_t(sum.first)],
                      &second = covered_.images()[std::size_t(sum.second)];
    const Vec3<double> arm = sum.coefficient_arm / sum.coefficient;
    friction_.push_back({first.sphere,
                         second.sphere,
                         sum.coefficient,
                         arm,
                         arm + first.centre - second.centre,
                         {second.velocity_jump - first.velocity_jump, 0, 0}});
  }
}

void ResolvedFluid::sweep(Member& member, const std::vector<ResolvedSphere>& spheres) {
  const auto kernel = lattice_.input.force_density == Vec3<double>{} ? sweep_ : forced_sweep_;
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
    kernel(lattice_, int(b), covered_, spheres, rows.begin, rows.end);
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
