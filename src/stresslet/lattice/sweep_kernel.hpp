#pragma once
/// The body of the kernel of sweep.hpp, instantiated in one source file per stencil and precision (sweep_*.cpp): each
/// holds every pair of a collision and a forcing law and takes its minute to compile.
#include <algorithm>

#include "stresslet/exec/first_lanes.hpp"
#include "stresslet/lattice/collide.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/pack_in_place.hpp"
#include "stresslet/lattice/sweep.hpp"

namespace stresslet {

/// Where the last cells of a row are stepped that do not fill a pack, so that they go through the same instructions as
/// all others: a compiler that fuses multiplications and additions need not do so alike in two copies of the code.
template <class Stencil, class T>
class PartialPack {
 public:
  using R = PackOf<T>;
  static constexpr std::ptrdiff_t width = R::size();

  PartialPack() {
    for (int i = 0; i < Stencil::size; ++i) places_[i] = &values_[std::size_t(i * width)];
  }
  const Sources<Stencil, T>& places() const { return places_; }
  void take(const Sources<Stencil, T>& source, std::ptrdiff_t first, std::ptrdiff_t cells) {
    for (int i = 0; i < Stencil::size; ++i) store(places_[i], load_first<R>(source[i] + first, cells));
  }
  void give_back(const Sources<Stencil, T>& source, std::ptrdiff_t first, std::ptrdiff_t cells) const {
    for (int i = 0; i < Stencil::size; ++i) store_first(source[i] + first, R(load(places_[i])), cells);
  }

 private:
  alignas(cache_line) std::array<T, std::size_t(Stencil::size* width)> values_{};
  Sources<Stencil, T> places_;
};

/// Steps rows of cells, pack by pack.
template <class Stencil, class T, class Collision, class Forcing>
class RowSweep {
 public:
  using R = PackOf<T>;
  using Rates = typename Collision::template Cell<Stencil, R>;
  static constexpr std::ptrdiff_t width = R::size(), line = cache_line / sizeof(T);

  [[gnu::always_inline]] RowSweep(const Populations<Stencil, T>& populations, Arrangement arrangement,
                                  const SweepInput& input)
      : rates_(input.rates),
        force_{{as<R>(input.force_density.x), as<R>(input.force_density.y), as<R>(input.force_density.z)},
               as<R>(input.rates.odd)},
        source_(sources_of(populations, arrangement)) {}

  /// `first` is the index of the row's first cell.
  [[gnu::always_inline]] void start(std::size_t first) { row_ = std::ptrdiff_t(first); }

  /// Asks for the line ahead of cell `x` of every population.
  [[gnu::always_inline]] void prefetch(std::ptrdiff_t x) const {
    prefetch_line<Stencil>(source_, row_ + x, prefetch_distance);
  }

  /// Steps the cells [x, x + width), or only the first `cells` of them, with `collide_cells(f, rates, force)`.
  template <class Collide>
  [[gnu::always_inline]] void step(std::ptrdiff_t x, std::ptrdiff_t cells, Collide&& collide_cells) {
    const bool whole = cells >= width;
    if (!whole) partial_.take(source_, row_ + x, cells);
    PackInPlace<Stencil, T> f(whole ? source_ : partial_.places(), whole ? row_ + x : 0);
    Rates rates = rates_;
    collide_cells(f, rates, force_);
    if (!whole) partial_.give_back(source_, row_ + x, cells);
  }
  [[gnu::always_inline]] void step(std::ptrdiff_t x, std::ptrdiff_t cells) {
    step(
        x, cells, [](auto& f, auto& rates, const auto& force) __attribute__((always_inline)) {
          collide<Collision, Forcing>(f, rates, force);
        });
  }

 private:
  Rates rates_;
  BodyForce<R> force_;
  Sources<Stencil, T> source_;
  PartialPack<Stencil, T> partial_;
  std::ptrdiff_t row_ = 0;
};

template <class Stencil, class T, class Collision, class Forcing>
void sweep(const Populations<Stencil, T>& populations, Arrangement arrangement, const SweepInput& input,
           std::size_t first, std::size_t last) {
  using Row = RowSweep<Stencil, T, Collision, Forcing>;
  constexpr std::ptrdiff_t width = Row::width, line = Row::line;
  Row cells(populations, arrangement, input);
  const BlockLayout& layout = populations.layout();
  const std::ptrdiff_t nx = layout.size()[0];
  const std::size_t ny = std::size_t(layout.size()[1]);
  for (std::size_t row = first; row < last; ++row) {
    cells.start(layout.index(0, int(row % ny), int(row / ny)));
    for (std::ptrdiff_t x = 0; x < nx; x += width) {
      if (x % line == 0) cells.prefetch(x);
      cells.step(x, std::min(width, nx - x));
    }
  }
}

template <class Stencil, class T>
Sweep<Stencil, T> sweep_for(std::string_view collision, std::string_view forcing) {
  Sweep<Stencil, T> found = nullptr;
  CollisionLaws::dispatch(collision, [&](auto c) {
    ForcingLaws::dispatch(
        forcing, [&](auto f) { found = sweep<Stencil, T, typename decltype(c)::type, typename decltype(f)::type>; });
  });
  return found;
}

}  // namespace stresslet
