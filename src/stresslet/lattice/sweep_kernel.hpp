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

/// Loads, collides and stores the cells [x, x + width) of a row; only the first `cells` of them are stored if masked.
template <class Stencil, class T, class Collision, class Forcing, bool masked>
[[gnu::always_inline]] inline void step_pack(const Sources<Stencil, T>& source, std::ptrdiff_t x, int cells,
                                             const typename Collision::template Cell<Stencil, PackOf<T>>& rates,
                                             const BodyForce<PackOf<T>>& force) {
  using R = PackOf<T>;
  const auto load = [&](int i) { return R(source[i] + x, stdx::element_aligned); };
  [[maybe_unused]] const typename R::mask_type inside = R([](auto lane) { return T(lane); }) < R(T(cells));
  const auto store = [&](int i, const R& value) {
    if constexpr (masked)
      stdx::where(inside, value).copy_to(source[i] + x, stdx::element_aligned);
    else
      value.copy_to(source[i] + x, stdx::element_aligned);
  };

  CellPopulations<Stencil, R> f;
  f.rest = load(0);
  unroll<Stencil::pairs>([&](auto k) {
    const R along = load(first_of_pair(k)), against = load(first_of_pair(k) + 1);
    f.pair[k] = {along + against, along - against};
  });
  auto collision = rates;
  collide<Collision, Forcing, Stencil, R>(f, collision, force);
  store(0, f.rest);
  unroll<Stencil::pairs>([&](auto k) {
    const R half = as<R>(0.5);
    store(first_of_pair(k) + 1, half * (f.pair[k].even + f.pair[k].odd));
    store(first_of_pair(k), half * (f.pair[k].even - f.pair[k].odd));
  });
}

template <class Stencil, class T, class Collision, class Forcing>
void sweep(const Populations<Stencil, T>& populations, Arrangement arrangement, const SweepInput& input,
           std::size_t first, std::size_t last) {
  using R = PackOf<T>;
  constexpr std::ptrdiff_t width = R::size(), line = cache_line / sizeof(T);
  const typename Collision::template Cell<Stencil, R> rates(input.rates);
  const BodyForce<R> force{{as<R>(input.force_density.x), as<R>(input.force_density.y), as<R>(input.force_density.z)},
                           as<R>(input.rates.odd)};
  const BlockLayout& layout = populations.layout();
  const std::ptrdiff_t nx = layout.size()[0];
  const int ny = layout.size()[1];

  for (std::size_t row = first; row < last; ++row) {
    Sources<Stencil, T> source;
    const std::size_t start = layout.index(0, int(row % std::size_t(ny)), int(row / std::size_t(ny)));
    for (int i = 0; i < Stencil::size; ++i) source[i] = populations.source(i, arrangement) + start;

    std::ptrdiff_t x = 0;
    for (; x + line <= nx; x += line) {
      for (int i = 0; i < Stencil::size; ++i)
        __builtin_prefetch(reinterpret_cast<const char*>(source[i] + x) + prefetch_distance, 1);
      for (std::ptrdiff_t k = 0; k < line; k += width)
        step_pack<Stencil, T, Collision, Forcing, false>(source, x + k, int(width), rates, force);
    }
    for (; x + width <= nx; x += width)
      step_pack<Stencil, T, Collision, Forcing, false>(source, x, int(width), rates, force);
    if (x < nx) step_pack<Stencil, T, Collision, Forcing, true>(source, x, int(nx - x), rates, force);
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
