#include <algorithm>
#include <vector>

#include "stresslet/coupling/operators/kinetic_stress.hpp"
#include "stresslet/coupling/resolved_sweep.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/pack_in_place.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);
constexpr int line = cache_line / sizeof(double);
constexpr std::size_t lines_ahead = 4;  // asked for before use

double total(const Pack& p) { return stdx::reduce(p); }
Vec3<double> total(const Vec3<Pack>& v) { return {total(v.x), total(v.y), total(v.z)}; }
SymTensor3<double> total(const SymTensor3<Pack>& t) {
  return {total(t.xx), total(t.yy), total(t.zz), total(t.xy), total(t.xz), total(t.yz)};
}
RunSums<double> total(const RunSums<Pack>& s) {
  return {total(s.mass), total(s.along), total(s.along_along), total(s.momentum), total(s.momentum_along)};
}

/// One row of a block: where it is covered, and what the fluid does there.
class GatherRow {
 public:
  explicit GatherRow(int nx)
      : covered_line_(std::size_t(nx / line + 1), 0), whole_(std::size_t(nx + line), 0.0), density_(whole_.size()) {
    for (auto& component : velocity_) component.resize(whole_.size());
    for (auto& component : stress_) component.resize(whole_.size());
  }

  /// Finds the drags of `runs`, those of the row that begins at index `start`, and the lines that they touch.
  void place(CoveredRuns& covered, const Range& runs, std::size_t start) {
    runs_ = runs;
    start_ = std::ptrdiff_t(start);
    covered.fill_drags(runs);
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      const double* drag = covered.drag(run);
      for (int p = 0; p < run.packs * width; p += width) {
        store(&whole_[std::size_t(run.x + p)], load(&whole_[std::size_t(run.x + p)]) + load(drag + p));
        covered_line_[std::size_t((run.x + p) / line)] = 1;
      }
    }
    lines_.clear();
    for (std::size_t k = 0; k < covered_line_.size(); ++k)
      if (covered_line_[k]) lines_.push_back(int(k) * line);
  }
  void clear() {
    for (const int x : lines_) {
      std::fill_n(&whole_[std::size_t(x)], line, 0.0);
      covered_line_[std::size_t(x / line)] = 0;
    }
    lines_.clear();
  }

  /// Reads the populations; meanwhile asks for those of lines further on, at last for the first ones of `next`.
  template <class Stencil>
  void read(const Sources<Stencil, double>& sources, const Vec3<Pack>& half_force, bool kinetic,
            const GatherRow& next) {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::size_t ahead = k + lines_ahead;
      if (ahead < lines_.size())
        prefetch_line<Stencil>(sources, start_ + lines_[ahead]);
      else if (ahead - lines_.size() < next.lines_.size())
        prefetch_line<Stencil>(sources, next.start_ + next.lines_[ahead - lines_.size()]);
      for (int x = lines_[k]; x < lines_[k] + line; x += width)
        if (stdx::any_of(load(&whole_[std::size_t(x)]) > Pack(0.0)))
          read_pack<Stencil>(sources, x, half_force, kinetic);
    }
  }

  const Range& runs() const { return runs_; }
  Pack whole(int x) const { return load(&whole_[std::size_t(x)]); }
  Pack density(int x) const { return load(&density_[std::size_t(x)]); }
  Vec3<Pack> velocity(int x) const {
    const auto at = [&](std::size_t a) { return load(&velocity_[a][std::size_t(x)]); };
    return {at(0), at(1), at(2)};
  }
  SymTensor3<Pack> stress(int x) const {
    const auto at = [&](std::size_t a) { return load(&stress_[a][std::size_t(x)]); };
    return {at(0), at(1), at(2), at(3), at(4), at(5)};
  }

 private:
  template <class Stencil>
  [[gnu::always_inline]] void read_pack(const Sources<Stencil, double>& sources, int x, const Vec3<Pack>& half_force,
                                        bool kinetic) {
    const PackInPlace<Stencil, double> f(sources, start_ + x);
    const Moments<Pack> m = moments_of(f);
    const Vec3<Pack> velocity = (m.momentum + half_force) / m.density();
    const auto keep = [&](AlignedVector<double>& row, const Pack& value) { store(&row[std::size_t(x)], value); };
    keep(density_, m.density());
    keep(velocity_[0], velocity.x), keep(velocity_[1], velocity.y), keep(velocity_[2], velocity.z);
    if (!kinetic) return;
    const SymTensor3<Pack> s = non_equilibrium_stress(f, velocity);
    keep(stress_[0], s.xx), keep(stress_[1], s.yy), keep(stress_[2], s.zz);
    keep(stress_[3], s.xy), keep(stress_[4], s.xz), keep(stress_[5], s.yz);
  }

  Range runs_{};
  std::ptrdiff_t start_ = 0;
  std::vector<int> lines_;                         ///< x of the first cells of covered lines, ascending
  std::vector<std::uint8_t> covered_line_;         ///< [x / line]
  AlignedVector<double> whole_, density_;          ///< sum of all drags; density
  std::array<AlignedVector<double>, 3> velocity_;  ///< u*
  std::array<AlignedVector<double>, 6> stress_;    ///< Pi_neq
};

/// The friction of a run with those of later images in its row.
void find_shared(const CoveredRuns& covered, const CoveredRun& run, const GatherRow& row,
                 std::vector<SharedRun>& shared) {
  const Pack lanes([](auto k) { return double(k); });
  const double* own = covered.drag(run);
  const SphereImage& image = covered.images()[std::size_t(run.image)];
  const Vec3<double> arm{run.global[0] - image.centre.x, run.global[1] - image.centre.y,
                         run.global[2] - image.centre.z};
  for (std::size_t k = row.runs().begin; k < row.runs().end; ++k) {
    const CoveredRun& other = covered.runs()[k];
    if (other.image <= run.image) continue;
    const int begin = std::max(run.x, other.x),
              end = std::min(run.x + run.packs * width, other.x + other.packs * width);
    Pack sum = 0.0, along = 0.0;
    for (int x = begin; x < end; x += width) {
      const Pack c = shared_cell_friction(row.density(x), load(own + (x - run.x)),
                                          load(covered.drag(other) + (x - other.x)), row.whole(x));
      sum += c;
      along += c * (lanes + double(x - run.x));
    }
    const double coefficient = total(sum);
    if (coefficient > 0)
      shared.push_back(
          {run.slot, run.image, other.image, coefficient, coefficient * arm + Vec3<double>{total(along), 0, 0}});
  }
}

void sum_runs(const CoveredRuns& covered, const GatherRow& row, const ExchangeFactors& factors, SlotSums& by_slot,
              std::vector<SharedRun>& shared) {
  const Pack lanes([](auto k) { return double(k); });
  const bool kinetic = factors.kinetic_stress != 0;
  for (std::size_t k = row.runs().begin; k < row.runs().end; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const double* drags = covered.drag(run);
    RunSums<Pack> sum{};
    SymTensor3<Pack> stress{};
    bool alone = true;
    for (int p = 0; p < run.packs * width; p += width) {
      const int x = run.x + p;
      const Pack drag = load(drags + p), whole = row.whole(x);
      if (stdx::none_of(drag > Pack(0.0))) continue;
      const Pack weight = share_of_weight(drag, whole);
      const Vec3<Pack> velocity = row.velocity(x);
      sum.add(Pack(factors.exchange) * weight * row.density(x), Pack(run.global[0] + p - image.centre.x) + lanes,
              {velocity.x - Pack(image.velocity_jump), velocity.y, velocity.z});
      if (kinetic) stress += Pack(factors.kinetic_stress) * weight * row.stress(x);
      alone = alone && stdx::all_of(whole == drag);
    }
    const std::size_t slot = std::size_t(run.slot);
    by_slot.exchange[slot] = {total(sum), run.global[1] - image.centre.y, run.global[2] - image.centre.z};
    if (kinetic) by_slot.kinetic[slot] = total(stress);
    if (!alone) find_shared(covered, run, row, shared);
  }
}

}  // namespace

template <class Stencil>
void gather_exchange(const Lattice<Stencil, double>& lattice, int block, CoveredRuns& covered,
                     const ExchangeFactors& factors, std::size_t first, std::size_t last, SlotSums& by_slot,
                     std::vector<SharedRun>& shared) {
  const Vec3<double>& force = lattice.input.force_density;
  const Vec3<Pack> half_force{Pack(0.5 * force.x), Pack(0.5 * force.y), Pack(0.5 * force.z)};
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const std::size_t ny = std::size_t(layout.size()[1]);
  const Sources<Stencil, double> sources = sources_of(populations, lattice.arrangement);

  // The next row is placed before this one is read, so that its first lines can be asked for.
  GatherRow row(layout.size()[0]), next(layout.size()[0]);
  std::size_t at = first;
  const auto place_next = [&] {
    for (; at < last; ++at) {
      const Range runs = covered.runs_of_row(block, at);
      if (runs.begin == runs.end) continue;
      next.place(covered, runs, layout.index(0, int(at % ny), int(at / ny)));
      ++at;
      return true;
    }
    return false;
  };
  for (bool more = place_next(); more;) {
    std::swap(row, next);
    more = place_next();
    row.read<Stencil>(sources, half_force, factors.kinetic_stress != 0, next);
    sum_runs(covered, row, factors, by_slot, shared);
    row.clear();
  }
}

template void gather_exchange<D3Q19>(const Lattice<D3Q19, double>&, int, CoveredRuns&, const ExchangeFactors&,
                                     std::size_t, std::size_t, SlotSums&, std::vector<SharedRun>&);

}  // namespace stresslet
