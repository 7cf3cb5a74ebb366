#pragma once
/// The body of the kernel of sweep.hpp, instantiated in one source file per stencil and precision (sweep_*.cpp): each
/// holds every pair of a collision and a forcing law and takes its minute to compile.
#include "stresslet/exec/simd.hpp"
#include "stresslet/lattice/collide.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/sweep.hpp"

namespace stresslet {

// Bytes ahead of use at which a line is asked for; without, the kernel runs at half its speed or less.
constexpr std::ptrdiff_t prefetch_distance = 256;

template <class Stencil, class T>
using Sources = std::array<T*, Stencil::size>;

/// Steps one row of cells, pack by pack.
template <class Stencil, class T, class Collision, class Forcing>
class RowSweep {
 public:
  using R = PackOf<T>;
  using Rates = typename Collision::template Cell<Stencil, R>;
  static constexpr std::ptrdiff_t width = R::size(), line = cache_line / sizeof(T);

  [[gnu::always_inline]] explicit RowSweep(const SweepInput& input)
      : rates_(input.rates),
        force_{{as<R>(input.force_density.x), as<R>(input.force_density.y), as<R>(input.force_density.z)},
               as<R>(input.rates.odd)} {}

  /// `start` is the index of the row's first cell.
  [[gnu::always_inline]] void start(const Populations<Stencil, T>& populations, Arrangement arrangement,
                                    std::size_t start) {
    for (int i = 0; i < Stencil::size; ++i) source_[i] = populations.source(i, arrangement) + start;
  }

  /// Asks for the line ahead of cell `x` of every population.
  [[gnu::always_inline]] void prefetch(std::ptrdiff_t x) const {
    for (int i = 0; i < Stencil::size; ++i)
      __builtin_prefetch(reinterpret_cast<const char*>(source_[i] + x) + prefetch_distance, 1);
  }

  /// Steps the cells [x, x + width), or only the first `cells` of them, with `collide_cells(f, rates, force)`.
  template <class Collide>
  [[gnu::always_inline]] void step(std::ptrdiff_t x, std::ptrdiff_t cells, Collide&& collide_cells) const {
    const auto load = [&](int i) __attribute__((always_inline)) { return R(source_[i] + x, stdx::element_aligned); };
    CellPopulations<Stencil, R> f;
    f.rest = load(0);
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
      const R along = load(first_of_pair(k)), against = load(first_of_pair(k) + 1);
      f.pair[k] = {along + against, along - against};
    });
    Rates rates = rates_;
    collide_cells(f, rates, force_);
    if (cells >= width)
      store_all(
          f, [&](int i, const R& value)
                 __attribute__((always_inline)) { value.copy_to(source_[i] + x, stdx::element_aligned); });
    else
      store_all(
          f, [&](int i, const R& value) __attribute__((always_inline)) {
            const typename R::mask_type inside = R([](auto lane) { return T(lane); }) < R(T(cells));
            stdx::where(inside, value).copy_to(source_[i] + x, stdx::element_aligned);
          });
  }
  [[gnu::always_inline]] void step(std::ptrdiff_t x, std::ptrdiff_t cells) const {
    step(
        x, cells, [](auto& f, auto& rates, const auto& force) __attribute__((always_inline)) {
          collide<Collision, Forcing>(f, rates, force);
        });
  }

 private:
  template <class Store>
  [[gnu::always_inline]] static void store_all(const CellPopulations<Stencil, R>& f, Store&& store) {
    const R half = as<R>(0.5);
    store(0, f.rest);
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
      store(first_of_pair(k) + 1, half * (f.pair[k].even + f.pair[k].odd));
      store(first_of_pair(k), half * (f.pair[k].even - f.pair[k].odd));
    });
  }

  Rates rates_;
  BodyForce<R> force_;
  Sources<Stencil, T> source_{};
};

template <class Stencil, class T, class Collision, class Forcing>
void sweep(const Populations<Stencil, T>& populations, Arrangement arrangement, const SweepInput& input,
           std::size_t first, std::size_t last) {
  using Row = RowSweep<Stencil, T, Collision, Forcing>;
  constexpr std::ptrdiff_t width = Row::width, line = Row::line;
  Row cells(input);
  const BlockLayout& layout = populations.layout();
  const std::ptrdiff_t nx = layout.size()[0];
  const int ny = layout.size()[1];
  for (std::size_t row = first; row < last; ++row) {
    cells.start(populations, arrangement, layout.index(0, int(row % std::size_t(ny)), int(row / std::size_t(ny))));
    std::ptrdiff_t x = 0;
    for (; x + line <= nx; x += line) {
      cells.prefetch(x);
      for (std::ptrdiff_t k = 0; k < line; k += width) cells.step(x + k, width);
    }
    for (; x < nx; x += width) cells.step(x, std::min(width, nx - x));
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
