#include <vector>

#include "stresslet/coupling/resolved_sweep.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);

template <class Stencil>
CellPopulations<Stencil, Pack> load_pack(const std::array<const double*, Stencil::size>& source, std::ptrdiff_t x) {
  const auto at = [&](int i) { return Pack(source[std::size_t(i)] + x, stdx::element_aligned); };
  CellPopulations<Stencil, Pack> f;
  f.rest = at(0);
  unroll<Stencil::pairs>([&](auto k) {
    const Pack along = at(first_of_pair(k)), against = at(first_of_pair(k) + 1);
    f.pair[k] = {along + against, along - against};
  });
  return f;
}

ExchangeSums<double> reduced(const ExchangeSums<Pack>& s) {
  const auto sum = [](const Pack& p) { return stdx::reduce(p); };
  const auto vector = [&](const Vec3<Pack>& v) { return Vec3<double>{sum(v.x), sum(v.y), sum(v.z)}; };
  return {sum(s.mass),
          vector(s.first),
          {sum(s.second.xx), sum(s.second.yy), sum(s.second.zz), sum(s.second.xy), sum(s.second.xz), sum(s.second.yz)},
          vector(s.momentum),
          {vector(s.momentum_arm[0]), vector(s.momentum_arm[1]), vector(s.momentum_arm[2])}};
}

/// Sum of the drags of all other images in the cells of a pack of run `own`.
Pack drag_of_others(const CoveredRuns& covered, std::size_t own, int pack) {
  const CoveredRun& run = covered.runs()[own];
  const int x = run.x + pack * width;
  Pack sum = 0.0;
  const auto [begin, end] = covered.runs_of_row(run.block, std::size_t(run.row));
  for (const std::int32_t* k = begin; k != end; ++k) {
    const CoveredRun& other = covered.runs()[std::size_t(*k)];
    const int p = (x - other.x) / width;
    if (std::size_t(*k) == own || x < other.x || p >= other.packs) continue;
    sum += load(covered.drag(other) + p * width);
  }
  return sum;
}

}  // namespace

template <class Stencil>
void gather_exchange(const Lattice<Stencil, double>& lattice, const CoveredRuns& covered, std::size_t first,
                     std::size_t last, ExchangeSums<double>* sums) {
  const Pack lanes([](auto k) { return double(k); });
  const Vec3<Pack> half_force{Pack(0.5 * lattice.input.force_density.x), Pack(0.5 * lattice.input.force_density.y),
                              Pack(0.5 * lattice.input.force_density.z)};
  for (std::size_t k = first; k < last; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const auto& populations = lattice.blocks[std::size_t(run.block)].populations;
    const BlockLayout& layout = populations.layout();
    const int ny = layout.size()[1];
    const std::size_t start = layout.index(run.x, run.row % ny, run.row / ny);
    std::array<const double*, Stencil::size> source;
    for (int i = 0; i < Stencil::size; ++i) source[std::size_t(i)] = populations.source(i, lattice.arrangement) + start;

    ExchangeSums<Pack> sum{};
    const Pack arm_y = run.global[1] - image.centre.y, arm_z = run.global[2] - image.centre.z;
    for (int p = 0; p < run.packs; ++p) {
      const Pack drag = load(covered.drag(run) + p * width);
      const Moments<Pack> m = moments_of(load_pack<Stencil>(source, p * width));
      const Pack share = share_of_weight(drag, Pack(drag + drag_of_others(covered, k, p)));
      const Pack density = m.density();
      Vec3<Pack> velocity = (m.momentum + half_force) / density;
      velocity.x -= Pack(image.velocity_jump);
      const Vec3<Pack> arm{Pack(run.global[0] + p * width - image.centre.x) + lanes, arm_y, arm_z};
      sum.add(share * density, arm, velocity);
    }
    sums[k] = reduced(sum);
  }
}

template void gather_exchange<D3Q19>(const Lattice<D3Q19, double>&, const CoveredRuns&, std::size_t, std::size_t,
                                     ExchangeSums<double>*);

}  // namespace stresslet
