#include <algorithm>
#include <vector>

#include "stresslet/coupling/gather_row.hpp"
#include "stresslet/coupling/resolved_sweep.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/exec/first_lanes.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

template <class P>
double total(const P& p) {
  return double(stdx::reduce(p));
}
template <class P>
Vec3<double> total(const Vec3<P>& v) {
  return {total(v.x), total(v.y), total(v.z)};
}
template <class P>
SymTensor3<double> total(const SymTensor3<P>& t) {
  return {total(t.xx), total(t.yy), total(t.zz), total(t.xy), total(t.xz), total(t.yz)};
}
template <class P>
RunSums<double> total(const RunSums<P>& s) {
  return {total(s.mass), total(s.along), total(s.along_along), total(s.momentum), total(s.momentum_along)};
}

/// The friction of run `k` with those of later images in its row, which come after it.
template <class T>
[[gnu::noinline]] void find_shared(const CoveredRuns<T>& covered, std::size_t k, const GatherRow<T>& row,
                                   std::vector<SharedRun>& shared) {
  using P = PackOf<T>;
  constexpr int width = CoveredRuns<T>::width;
  const P lanes([](auto lane) { return T(lane); });
  const CoveredRun& run = covered.runs()[k];
  const T* own = covered.drag(run);
  for (std::size_t j = k + 1; j < row.runs().end; ++j) {
    const CoveredRun& other = covered.runs()[j];
    const int begin = std::max(run.x, other.x), end = std::min(run.x + run.cells, other.x + other.cells);
    if (begin >= end || other.image == run.image) continue;
    const T* of_other = covered.drag(other);
    P sum = T(0), along = T(0);
    for (int x = begin; x < end; x += width) {
      const P c = shared_cell_friction(row.density(x), load_first<P>(own + (x - run.x), end - x),
                                       load_first<P>(of_other + (x - other.x), end - x));
      sum += c;
      along += c * (lanes + P(T(x - run.x)));
    }
    const double coefficient = total(sum);
    if (!(coefficient > 0)) continue;
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const Vec3<double> arm = run.arm(image.centre);
    shared.push_back(
        {run.slot, run.image, other.image, coefficient, coefficient * arm + Vec3<double>{total(along), 0, 0}});
  }
}

template <class T>
void sum_runs(const CoveredRuns<T>& covered, const GatherRow<T>& row, const ExchangeFactors& factors, SlotSums& by_slot,
              std::vector<SharedRun>& shared) {
  using P = PackOf<T>;
  constexpr int width = CoveredRuns<T>::width;
  const P lanes([](auto k) { return T(k); });
  const bool kinetic = factors.kinetic_stress != 0;
  for (std::size_t k = row.runs().begin; k < row.runs().end; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const T* drags = covered.drag(run);
    RunSums<P> sum{};
    SymTensor3<P> stress{};
    P of_others = T(0);
    const Vec3<double> arm = run.arm(image.centre);
    P along = P(T(arm.x)) + lanes;
    for (int p = 0; p < run.packs * width; p += width, along += P(T(width))) {
      const int x = run.x + p;
      const P drag = load(drags + p);
      sum.add(drag * row.density(x), drag * row.momentum(x), along);
      if (kinetic) stress += drag * row.stress(x);
      of_others += drag * (row.whole(x) - drag);
    }
    const std::size_t slot = std::size_t(run.slot);
    RunSums<double> exchange = factors.exchange * total(sum);
    exchange.change_frame(image.velocity_jump);
    by_slot.exchange.data()[slot] = {exchange, arm.y, arm.z};
    if (kinetic) by_slot.kinetic[slot] = factors.kinetic_stress * total(stress);
    if (stdx::any_of(of_others > P(T(0)))) find_shared(covered, k, row, shared);
  }
}

}  // namespace

template <class Stencil, class T>
void gather_exchange(const Lattice<Stencil, T>& lattice, int block, const RowExchange<Stencil, T>* across_x,
                     CoveredRuns<T>& covered, const ExchangeFactors& factors, std::size_t first, std::size_t last,
                     SlotSums& by_slot, std::vector<SharedRun>& shared) {
  const Vec3<double>& force = lattice.input.force_density;
  using P = PackOf<T>;
  const Vec3<P> half_force{P(T(0.5 * force.x)), P(T(0.5 * force.y)), P(T(0.5 * force.z))};
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const std::size_t ny = std::size_t(layout.size()[1]);
  const Sources<Stencil, T> sources = sources_of(populations, lattice.arrangement);

  // The next row is placed before this one is read, so that its first lines can be asked for.
  GatherRow<T> rows[2]{GatherRow<T>(layout.size()[0]), GatherRow<T>(layout.size()[0])};
  GatherRow<T>*row = &rows[0], *next = &rows[1];
  std::size_t at = first;
  const auto place_next = [&] {
    for (; at < last; ++at) {
      const Range runs = covered.runs_of_row(block, at);
      if (runs.begin == runs.end) continue;
      next->place(covered, runs, layout.index(0, int(at % ny), int(at / ny)));
      if (across_x) across_x->bring_in(block, int(at % ny), int(at / ny));
      for (std::size_t k = runs.begin; k < runs.end; ++k) by_slot.ask_for(std::size_t(covered.runs()[k].slot));
      ++at;
      return true;
    }
    return false;
  };
  for (bool more = place_next(); more;) {
    std::swap(row, next);
    more = place_next();
    row->template read<Stencil>(sources, half_force, factors.kinetic_stress != 0, *next);
    sum_runs(covered, *row, factors, by_slot, shared);
    row->clear();
  }
}

template void gather_exchange(const Lattice<D3Q19, double>&, int, const RowExchange<D3Q19, double>*,
                              CoveredRuns<double>&, const ExchangeFactors&, std::size_t, std::size_t, SlotSums&,
                              std::vector<SharedRun>&);
template void gather_exchange(const Lattice<D3Q19, float>&, int, const RowExchange<D3Q19, float>*, CoveredRuns<float>&,
                              const ExchangeFactors&, std::size_t, std::size_t, SlotSums&, std::vector<SharedRun>&);

}  // namespace stresslet
