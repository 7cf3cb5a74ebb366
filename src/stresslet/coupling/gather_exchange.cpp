#include <vector>

#include "stresslet/coupling/operators/kinetic_stress.hpp"
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
  const auto tensor = [&](const SymTensor3<Pack>& t) {
    return SymTensor3<double>{sum(t.xx), sum(t.yy), sum(t.zz), sum(t.xy), sum(t.xz), sum(t.yz)};
  };
  return {sum(s.mass),
          vector(s.first),
          tensor(s.second),
          vector(s.momentum),
          {vector(s.momentum_arm[0]), vector(s.momentum_arm[1]), vector(s.momentum_arm[2])},
          tensor(s.kinetic)};
}

/// Another run that covers cells of a run, and the friction with it so far.
struct SharedWith {
  const CoveredRun* run;
  const double* drag;
  Pack coefficient, along;  // sums of c and of c x; the other coordinates are the row's
};

/// The drags of `n` in the pack of cells that begins at `x`, zero where it covers none.
Pack drag_at(const SharedWith& n, int x) {
  const int p = (x - n.run->x) / width;
  return x < n.run->x || p >= n.run->packs ? Pack(0.0) : load(n.drag + p * width);
}

void find_neighbours(const CoveredRuns& covered, std::size_t own, std::vector<SharedWith>& found) {
  found.clear();
  const CoveredRun& run = covered.runs()[own];
  const auto [begin, end] = covered.runs_of_row(run.block, std::size_t(run.row));
  for (const std::int32_t* k = begin; k != end; ++k) {
    const CoveredRun& other = covered.runs()[std::size_t(*k)];
    const bool apart = other.x >= run.x + run.packs * width || run.x >= other.x + other.packs * width;
    if (std::size_t(*k) != own && !apart) found.push_back({&other, covered.drag(other), 0.0, 0.0});
  }
}

}  // namespace

template <class Stencil>
void gather_exchange(const Lattice<Stencil, double>& lattice, const CoveredRuns& covered,
                     const ExchangeFactors& factors, std::size_t first, std::size_t last, ExchangeSums<double>* sums,
                     std::vector<SharedRun>& shared) {
  const Pack lanes([](auto k) { return double(k); });
  const Vec3<Pack> half_force{Pack(0.5 * lattice.input.force_density.x), Pack(0.5 * lattice.input.force_density.y),
                              Pack(0.5 * lattice.input.force_density.z)};
  std::vector<SharedWith> neighbours;
  for (std::size_t k = first; k < last; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const auto& populations = lattice.blocks[std::size_t(run.block)].populations;
    const BlockLayout& layout = populations.layout();
    const int ny = layout.size()[1];
    const std::size_t start = layout.index(run.x, run.row % ny, run.row / ny);
    std::array<const double*, Stencil::size> source;
    for (int i = 0; i < Stencil::size; ++i) source[std::size_t(i)] = populations.source(i, lattice.arrangement) + start;
    find_neighbours(covered, k, neighbours);

    ExchangeSums<Pack> sum{};
    const Pack arm_y = run.global[1] - image.centre.y, arm_z = run.global[2] - image.centre.z;
    for (int p = 0; p < run.packs; ++p) {
      const int x = run.x + p * width;
      const Pack drag = load(covered.drag(run) + p * width);
      const CellPopulations<Stencil, Pack> f = load_pack<Stencil>(source, p * width);
      const Moments<Pack> m = moments_of(f);
      const Pack density = m.density();
      const Vec3<Pack> velocity = (m.momentum + half_force) / density;
      const Vec3<Pack> arm{Pack(run.global[0] + p * width - image.centre.x) + lanes, arm_y, arm_z};
      Pack whole_drag = drag;
      for (const SharedWith& n : neighbours) whole_drag += drag_at(n, x);
      for (SharedWith& n : neighbours)
        if (n.run->image > run.image) {
          const Pack c = shared_cell_friction(density, drag, drag_at(n, x), whole_drag);
          n.coefficient += c;
          n.along += c * arm.x;
        }
      const Pack weight = share_of_weight(drag, whole_drag);
      sum.add(Pack(factors.exchange) * weight * density, arm,
              {velocity.x - Pack(image.velocity_jump), velocity.y, velocity.z});
      if (factors.kinetic_stress != 0)
        sum.kinetic += Pack(factors.kinetic_stress) * weight * non_equilibrium_stress(f, velocity);
    }
    sums[k] = reduced(sum);
    for (const SharedWith& n : neighbours) {
      const double c = stdx::reduce(n.coefficient);
      if (c > 0)
        shared.push_back(
            {run.image,
             n.run->image,
             c,
             {stdx::reduce(n.along), c * (run.global[1] - image.centre.y), c * (run.global[2] - image.centre.z)}});
    }
  }
}

template void gather_exchange<D3Q19>(const Lattice<D3Q19, double>&, const CoveredRuns&, const ExchangeFactors&,
                                     std::size_t, std::size_t, ExchangeSums<double>*, std::vector<SharedRun>&);

}  // namespace stresslet
