#include <algorithm>
#include <vector>

#include "stresslet/coupling/operators/kinetic_stress.hpp"
#include "stresslet/coupling/resolved_sweep.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);
constexpr std::size_t prefetched_runs = 3;  // ahead of use

template <class Stencil>
[[gnu::always_inline]] inline CellPopulations<Stencil, Pack> load_pack(
    const std::array<const double*, Stencil::size>& source, std::ptrdiff_t x) {
  const auto at = [&](int i) __attribute__((always_inline)) {
    return Pack(source[std::size_t(i)] + x, stdx::element_aligned);
  };
  CellPopulations<Stencil, Pack> f;
  f.rest = at(0);
  unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
    const Pack along = at(first_of_pair(k)), against = at(first_of_pair(k) + 1);
    f.pair[k] = {along + against, along - against};
  });
  return f;
}

RunSums<double> reduced(const RunSums<Pack>& s, bool kinetic) {
  const auto sum = [](const Pack& p) { return stdx::reduce(p); };
  const auto vector = [&](const Vec3<Pack>& v) { return Vec3<double>{sum(v.x), sum(v.y), sum(v.z)}; };
  RunSums<double> r{sum(s.mass), sum(s.along), sum(s.along_along), vector(s.momentum), vector(s.momentum_along)};
  const SymTensor3<Pack>& t = s.kinetic;
  if (kinetic) r.kinetic = {sum(t.xx), sum(t.yy), sum(t.zz), sum(t.xy), sum(t.xz), sum(t.yz)};
  return r;
}

/// The friction of a run with those of later images in its row; `whole` holds the sum of all drags of the row.
void find_shared(const CoveredRuns& covered, const CoveredRun& run, const Range& row, const double* whole,
                 const double* density, std::vector<SharedRun>& shared) {
  const double* own = covered.drag(run);
  const SphereImage& image = covered.images()[std::size_t(run.image)];
  const Vec3<double> arm{run.global[0] - image.centre.x, run.global[1] - image.centre.y,
                         run.global[2] - image.centre.z};
  for (std::size_t k = row.begin; k < row.end; ++k) {
    const CoveredRun& other = covered.runs()[k];
    if (other.image <= run.image) continue;
    SharedRun found{run.slot, run.image, other.image};
    const int begin = std::max(run.x, other.x),
              end = std::min(run.x + run.packs * width, other.x + other.packs * width);
    for (int x = begin; x < end; ++x) {
      const double c = shared_cell_friction(density[x], own[x - run.x], covered.drag(other)[x - other.x], whole[x]);
      found.coefficient += c;
      found.coefficient_arm += c * (arm + Vec3<double>{double(x - run.x), 0, 0});
    }
    if (found.coefficient > 0) shared.push_back(found);
  }
}

}  // namespace

template <class Stencil>
void gather_exchange(const Lattice<Stencil, double>& lattice, int block, CoveredRuns& covered,
                     const ExchangeFactors& factors, std::size_t first, std::size_t last, RunExchange* by_slot,
                     std::vector<SharedRun>& shared) {
  const Pack lanes([](auto k) { return double(k); });
  const Vec3<Pack> half_force{Pack(0.5 * lattice.input.force_density.x), Pack(0.5 * lattice.input.force_density.y),
                              Pack(0.5 * lattice.input.force_density.z)};
  const bool kinetic = factors.kinetic_stress != 0;
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  std::array<const double*, Stencil::size> source;
  for (int i = 0; i < Stencil::size; ++i) source[std::size_t(i)] = populations.source(i, lattice.arrangement);
  const std::size_t end_of_runs = covered.runs_of_row(block, last - 1).end;
  const auto prefetch = [&](std::size_t k) {
    if (k >= end_of_runs) return;
    const CoveredRun& run = covered.runs()[k];
    const std::size_t start = layout.index(run.x, run.y, run.z);
    for (const double* s : source)
      for (int x = 0; x < run.packs * width; x += int(cache_line / sizeof(double))) __builtin_prefetch(s + start + x);
  };

  // Of one row, all images together.
  AlignedVector<double> whole(std::size_t(layout.size()[0] + width), 0.0), density(whole.size());
  for (std::size_t row = first; row < last; ++row) {
    const Range runs = covered.runs_of_row(block, row);
    covered.fill_drags(runs);
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      const double* drag = covered.drag(run);
      for (int p = 0; p < run.packs * width; p += width)
        store(&whole[std::size_t(run.x + p)], load(&whole[std::size_t(run.x + p)]) + load(drag + p));
    }
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      prefetch(k + prefetched_runs);
      const CoveredRun& run = covered.runs()[k];
      const SphereImage& image = covered.images()[std::size_t(run.image)];
      const std::size_t start = layout.index(run.x, run.y, run.z);
      const double* drags = covered.drag(run);
      RunSums<Pack> sum{};
      bool alone = true;
      for (int p = 0; p < run.packs * width; p += width) {
        const Pack drag = load(drags + p), whole_drag = load(&whole[std::size_t(run.x + p)]);
        if (stdx::none_of(drag > Pack(0.0))) continue;
        const CellPopulations<Stencil, Pack> f = load_pack<Stencil>(source, std::ptrdiff_t(start) + p);
        const Moments<Pack> m = moments_of(f);
        const Pack mass_density = m.density();
        const Vec3<Pack> velocity = (m.momentum + half_force) / mass_density;
        const Pack weight = share_of_weight(drag, whole_drag);
        sum.add(Pack(factors.exchange) * weight * mass_density, Pack(run.global[0] + p - image.centre.x) + lanes,
                {velocity.x - Pack(image.velocity_jump), velocity.y, velocity.z});
        if (kinetic) sum.kinetic += Pack(factors.kinetic_stress) * weight * non_equilibrium_stress(f, velocity);
        store(&density[std::size_t(run.x + p)], mass_density);
        alone = alone && stdx::all_of(whole_drag == drag);
      }
      by_slot[run.slot] = {reduced(sum, kinetic), run.global[1] - image.centre.y, run.global[2] - image.centre.z};
      if (!alone) find_shared(covered, run, runs, whole.data(), density.data(), shared);
    }
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      std::fill_n(&whole[std::size_t(run.x)], run.packs * width, 0.0);
    }
  }
}

template void gather_exchange<D3Q19>(const Lattice<D3Q19, double>&, int, CoveredRuns&, const ExchangeFactors&,
                                     std::size_t, std::size_t, RunExchange*, std::vector<SharedRun>&);

}  // namespace stresslet
