#pragma once
/// What solids would take of the fluid in one row of cells, read from its incoming populations.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "stresslet/coupling/covered_runs.hpp"
#include "stresslet/coupling/operators/kinetic_stress.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/exec/aligned.hpp"
#include "stresslet/lattice/pack_in_place.hpp"

namespace stresslet {

/// One row of a block: where it is covered, and what a solid of drag 1 would take of the fluid there: with a the sum of
/// all drags, density, momentum and stress over 1 + a/2 (shared_cells.hpp).
template <class T>
class GatherRow {
 public:
  using P = PackOf<T>;
  static constexpr int width = CoveredRuns<T>::width, line = cache_line / sizeof(T);

  explicit GatherRow(int nx)
      : covered_line_(std::size_t(nx / line + 1), 0), whole_(std::size_t(nx + line), T(0)), density_(whole_.size()) {
    for (auto& component : momentum_) component.resize(whole_.size());
    for (auto& component : stress_) component.resize(whole_.size());
  }

  /// Finds the drags of `runs`, those of the row that begins at index `start`, and the lines that they touch.
  void place(CoveredRuns<T>& covered, const Range& runs, std::size_t start) {
    runs_ = runs;
    start_ = std::ptrdiff_t(start);
    covered.fill_drags(runs);
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      const T* drag = covered.drag(run);
      for (int p = 0; p < run.packs * width; p += width) {
        T* const sum = &whole_[std::size_t(run.x + p)];
        store_unaligned(sum, load_unaligned(sum) + load(drag + p));
      }
      for (int at = run.x / line; at <= (run.x + run.cells - 1) / line; ++at) covered_line_[std::size_t(at)] = 1;
    }
    lines_.clear();
    for (std::size_t k = 0; k < covered_line_.size(); ++k)
      if (covered_line_[k]) lines_.push_back(int(k) * line);
  }
  void clear() {
    for (const int x : lines_) {
      std::fill_n(&whole_[std::size_t(x)], line, T(0));
      covered_line_[std::size_t(x / line)] = 0;
    }
    lines_.clear();
  }

  /// Reads the populations; meanwhile asks for those of lines further on, at last for the first ones of `next`.
  template <class Stencil>
  void read(const Sources<Stencil, T>& sources, const Vec3<P>& half_force, bool kinetic, const GatherRow& next) {
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::size_t ahead = k + lines_ahead;
      if (ahead < lines_.size())
        prefetch_line<Stencil>(sources, start_ + lines_[ahead]);
      else if (ahead - lines_.size() < next.lines_.size())
        prefetch_line<Stencil>(sources, next.start_ + next.lines_[ahead - lines_.size()]);
      for (int x = lines_[k]; x < lines_[k] + line; x += width)
        if (stdx::any_of(whole(x) > P(T(0)))) read_pack<Stencil>(sources, x, half_force, kinetic);
    }
  }

  const Range& runs() const { return runs_; }
  // Packs at any x.
  P whole(int x) const { return load_unaligned(&whole_[std::size_t(x)]); }
  P density(int x) const { return load_unaligned(&density_[std::size_t(x)]); }
  Vec3<P> momentum(int x) const {
    const auto at = [&](std::size_t a) { return load_unaligned(&momentum_[a][std::size_t(x)]); };
    return {at(0), at(1), at(2)};
  }
  SymTensor3<P> stress(int x) const {
    const auto at = [&](std::size_t a) { return load_unaligned(&stress_[a][std::size_t(x)]); };
    return {at(0), at(1), at(2), at(3), at(4), at(5)};
  }

 private:
  static constexpr std::size_t lines_ahead = 4;  ///< asked for before use

  template <class Stencil>
  [[gnu::always_inline]] void read_pack(const Sources<Stencil, T>& sources, int x, const Vec3<P>& half_force,
                                        bool kinetic) {
    const PackInPlace<Stencil, T> f(sources, start_ + x);
    const Moments<P> m = moments_of(f);
    const P share = share_of_weight(P(T(1)), whole(x));
    const Vec3<P> momentum = m.momentum + half_force;
    const auto keep = [&](AlignedVector<T>& row, const P& value) { store(&row[std::size_t(x)], share * value); };
    keep(density_, m.density());
    keep(momentum_[0], momentum.x), keep(momentum_[1], momentum.y), keep(momentum_[2], momentum.z);
    if (!kinetic) return;
    const SymTensor3<P> s = non_equilibrium_stress(f, momentum / m.density());
    keep(stress_[0], s.xx), keep(stress_[1], s.yy), keep(stress_[2], s.zz);
    keep(stress_[3], s.xy), keep(stress_[4], s.xz), keep(stress_[5], s.yz);
  }

  Range runs_{};
  std::ptrdiff_t start_ = 0;
  std::vector<int> lines_;                  ///< x of the first cells of covered lines, ascending
  std::vector<std::uint8_t> covered_line_;  ///< [x / line]
  AlignedVector<T> whole_;                  ///< sum of all drags
  AlignedVector<T> density_;
  std::array<AlignedVector<T>, 3> momentum_;
  std::array<AlignedVector<T>, 6> stress_;  ///< of Pi_neq
};

}  // namespace stresslet
