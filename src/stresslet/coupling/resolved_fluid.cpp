#include "stresslet/coupling/resolved_fluid.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

#include "stresslet/coupling/laws.hpp"

namespace stresslet {

namespace {

FluidSetup with_force(FluidSetup setup) {
  setup.forcing = Guo::name;
  return setup;
}

ExchangeFactors factors_of(const std::string& coupling_operator) {
  ExchangeFactors factors;
  CouplingOperators::dispatch(coupling_operator, [&](auto law) {
    using Law = typename decltype(law)::type;
    factors = {Law::exchange, Law::kinetic_stress_factor};
  });
  return factors;
}

double core_weight_of(const std::string& coupling_operator) {
  double weight = 0;
  CouplingOperators::dispatch(coupling_operator, [&](auto law) { weight = decltype(law)::type::core_weight; });
  return weight;
}

double velocity_difference(const FluidSetup& setup) {
  if (setup.grid.closure[1] == Closure::sheared) return setup.shear_velocity_lu;
  if (setup.grid.closure[1] != Closure::open) return 0;
  const auto& [low, high] = setup.faces[1];
  return high.velocity_lu.x - low.velocity_lu.x;
}

}  // namespace

std::unique_ptr<ResolvedFluid> ResolvedFluid::make(const FluidSetup& setup, const CouplingSetup& coupling) {
  if (setup.single_precision) return std::make_unique<ResolvedFluidOf<float>>(setup, coupling);
  return std::make_unique<ResolvedFluidOf<double>>(setup, coupling);
}

template <class T>
ResolvedFluidOf<T>::ResolvedFluidOf(const FluidSetup& setup, const CouplingSetup& coupling)
    : Base(with_force(setup)),
      velocity_difference_(velocity_difference(setup)),
      resolved_sweep_(resolved_sweep_for<Stencil, T>(setup.collision, coupling.coupling_operator, false)),
      forced_sweep_(resolved_sweep_for<Stencil, T>(setup.collision, coupling.coupling_operator, true)),
      row_energy_(row_energy_for<Stencil, T>(setup.collision, coupling.coupling_operator)),
      covered_(setup.grid, {coupling.solid.fraction, coupling.solid.weight, setup.rates.relaxation_time,
                            core_weight_of(coupling.coupling_operator)}),
      factors_(factors_of(coupling.coupling_operator)) {}

template <class T>
void ResolvedFluidOf<T>::prepare(Member& member, const std::vector<ResolvedSphere>& spheres) {
  prepare_step(lattice_, boundaries_, member, boundaries_.rows_exchanged());
  replace_populations(lattice_, boundaries_, member);
  covered_.place(member, spheres, lattice_.shear_offset, lattice_.shear_velocity);
  if (member.rank() == 0) {
    by_slot_.resize(covered_.runs().size(), factors_.kinetic_stress != 0);
    exchange_.resize(spheres.size());
    shared_.resize(std::size_t(member.size()));
    friction_of_.resize(std::size_t(member.size()));
  }
  member.barrier();
  const auto* across_x = boundaries_.in_sweep(lattice_.arrangement);
  // Filled on this thread's stack: every run moves the end, and those of all threads share a cache line.
  std::vector<SharedRun> shared = std::move(shared_[std::size_t(member.rank())]);
  shared.clear();
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
    if (rows.begin < rows.end)
      gather_exchange(lattice_, int(b), across_x, covered_, factors_, rows.begin, rows.end, by_slot_, shared);
  }
  shared_[std::size_t(member.rank())] = std::move(shared);
  member.barrier();
  const Range mine = member.share(spheres.size());
  for (std::size_t k = mine.begin; k < mine.end; ++k) {
    ExchangeSums sum;
    const Range images = covered_.images_of_sphere(k);
    for (std::size_t i = images.begin; i < images.end; ++i) {
      const Range slots = covered_.slots_of_image(i);
      by_slot_.add_to(sum, slots.begin, slots.end);
    }
    exchange_[k] = sum;
  }
  find_friction(member);
  member.barrier();
  if (member.rank() == 0) {
    friction_.clear();
    for (const auto& of_member : friction_of_) friction_.insert(friction_.end(), of_member.begin(), of_member.end());
    find_across();
  }
  member.barrier();
}

/// Summed in the order of slots, whatever the division of the work.
template <class T>
void ResolvedFluidOf<T>::find_friction(Member& member) {
  const Range mine = member.share(covered_.images().size());
  const auto for_each_of_mine = [&](auto&& visit) {
    for (const auto& of_thread : shared_)
      for (const SharedRun& run : of_thread)
        if (std::size_t(run.first) >= mine.begin && std::size_t(run.first) < mine.end)
          visit(run, std::size_t(run.first) - mine.begin);
  };
  // By the first image by counting; those of one image, some tens, are sorted.
  std::vector<std::size_t> begin(mine.end - mine.begin + 1, 0);
  for_each_of_mine([&](const SharedRun&, std::size_t image) { ++begin[image + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<SharedRun> all(begin.back());
  std::vector<std::size_t> next = begin;
  for_each_of_mine([&](const SharedRun& run, std::size_t image) { all[next[image]++] = run; });
  for (std::size_t k = 0; k + 1 < begin.size(); ++k)
    std::sort(
        all.begin() + std::ptrdiff_t(begin[k]), all.begin() + std::ptrdiff_t(begin[k + 1]),
        [](const SharedRun& a, const SharedRun& b) { return std::tie(a.second, a.slot) < std::tie(b.second, b.slot); });
  std::vector<PointFriction>& found = friction_of_[std::size_t(member.rank())];
  found.clear();
  for (auto group = all.begin(); group != all.end();) {
    SharedRun sum{0, group->first, group->second};
    for (; group != all.end() && group->first == sum.first && group->second == sum.second; ++group) {
      sum.coefficient += group->coefficient;
      sum.coefficient_arm += group->coefficient_arm;
    }
    const SphereImage &first = covered_.images()[std::size_t(sum.first)],
                      &second = covered_.images()[std::size_t(sum.second)];
    const Vec3<double> arm = sum.coefficient_arm / sum.coefficient;
    found.push_back({first.sphere,
                     second.sphere,
                     sum.coefficient,
                     arm,
                     arm + first.centre - second.centre,
                     {second.velocity_jump - first.velocity_jump, 0, 0}});
  }
}

template <class T>
void ResolvedFluidOf<T>::find_across() {
  across_.clear();
  for (std::size_t i = 0; i < covered_.images().size(); ++i) {
    const SphereImage& image = covered_.images()[i];
    if (image.velocity_jump == 0) continue;
    const bool above = (image.velocity_jump > 0) == (lattice_.shear_velocity > 0);
    across_.push_back({image.sphere, above ? 1 : -1, {}});
    const Range slots = covered_.slots_of_image(i);
    by_slot_.add_to(across_.back().sums, slots.begin, slots.end);
  }
}

template <class T>
void ResolvedFluidOf<T>::sweep(Member& member, const std::vector<ResolvedSphere>& spheres) {
  const auto kernel = lattice_.input.force_density == Vec3<double>{} ? resolved_sweep_ : forced_sweep_;
  const auto* across_x = boundaries_.in_sweep(lattice_.arrangement);
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
    kernel(lattice_, int(b), across_x, covered_, spheres, rows.begin, rows.end);
  }
  finish_step(lattice_, boundaries_, member, boundaries_.rows_exchanged());
}

template <class T>
double ResolvedFluidOf<T>::momentum_across(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres) {
  Base::prepare(team);
  if (lattice_.grid.closure[1] == Closure::open) return wall_momentum_upwards(lattice_, velocity_difference_);
  return fluid_momentum_across(lattice_) + solid_momentum_across(across_, spheres);
}

template <class T>
FluidEnergy ResolvedFluidOf<T>::energy(ThreadTeam& team, const std::vector<ResolvedSphere>& spheres,
                                       std::vector<FreeFluid>& free) {
  std::vector<FluidEnergy> by_row;
  std::vector<std::size_t> first_row(1, 0);
  for (const auto& block : lattice_.blocks) first_row.push_back(first_row.back() + block.populations.layout().rows());
  by_row.resize(first_row.back());
  const double shear_rate = velocity_difference_ / lattice_.grid.size[1];
  team.run([&](Member& member) {
    prepare_step(lattice_, boundaries_, member);
    covered_.place(member, spheres, lattice_.shear_offset, lattice_.shear_velocity);
    for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
      const Range rows = member.share(lattice_.blocks[b].populations.layout().rows());
      for (std::size_t row = rows.begin; row < rows.end; ++row) covered_.fill_drags(covered_.runs_of_row(int(b), row));
      row_energy_(lattice_, int(b), covered_, spheres, shear_rate, rows, &by_row[first_row[b]]);
    }
  });
  FluidEnergy sum;
  for (const FluidEnergy& row : by_row) add_row(sum, row);
  free.assign(std::size_t(lattice_.grid.size[1]), {});
  for (std::size_t b = 0; b < lattice_.blocks.size(); ++b) {
    const Cells &origin = lattice_.blocks[b].origin, &size = lattice_.blocks[b].populations.layout().size();
    for (std::size_t row = first_row[b]; row < first_row[b + 1]; ++row)
      free[std::size_t(origin[1]) + (row - first_row[b]) % std::size_t(size[1])] += by_row[row].free;
  }
  return sum;
}

template class ResolvedFluidOf<double>;
template class ResolvedFluidOf<float>;

}  // namespace stresslet
