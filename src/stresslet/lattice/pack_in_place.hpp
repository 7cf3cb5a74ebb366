#pragma once
/// One SIMD pack of cells, read and written where its populations lie.
#include <array>
#include <bit>

#include "stresslet/exec/simd.hpp"
#include "stresslet/lattice/moments.hpp"
#include "stresslet/lattice/populations.hpp"

namespace stresslet {

/// Of every population, the array that holds the incoming one (Populations::source).
template <class Stencil, class T>
using Sources = std::array<T*, Stencil::size>;

template <class Stencil, class T>
Sources<Stencil, T> sources_of(const Populations<Stencil, T>& populations, Arrangement arrangement) {
  Sources<Stencil, T> sources;
  for (int i = 0; i < Stencil::size; ++i) sources[std::size_t(i)] = populations.source(i, arrangement);
  return sources;
}

/// Bytes ahead of use at which a line is asked for; without, the sweep runs at half its speed or less.
inline constexpr std::ptrdiff_t prefetch_distance = 256;

/// Asks for a cache line of every population, `distance` bytes after index `first`.
template <class Stencil, class T>
[[gnu::always_inline]] inline void prefetch_line(const Sources<Stencil, T>& sources, std::ptrdiff_t first,
                                                 std::ptrdiff_t distance = 0) {
  unroll<Stencil::size>([&](auto i) __attribute__((always_inline)) {
    __builtin_prefetch(reinterpret_cast<const char*>(sources[i] + first) + distance, 1);
  });
}

/// The incoming populations of one pack of cells where they lie in memory; outgoing ones replace them there. Every
/// place belongs to one cell (populations.hpp), so a pair may be read again until it is written.
template <class Stencil_, class T>
class PackInPlace {
 public:
  using Stencil = Stencil_;
  using R = PackOf<T>;

  [[gnu::always_inline]] PackInPlace(const Sources<Stencil, T>& source, std::ptrdiff_t first)
      : source_(source), first_(first) {}

  [[gnu::always_inline]] R read_rest() const { return load(0); }
  template <int k>
  [[gnu::always_inline]] EvenOdd<R> read() const {
    const R along = load(first_of_pair(k)), against = load(first_of_pair(k) + 1);
    return {along + against, along - against};
  }
  [[gnu::always_inline]] void write_rest(const R& value) { store(0, value); }
  template <int k>
  [[gnu::always_inline]] void write(const EvenOdd<R>& value) {
    const R half_even = as<R>(0.5) * value.even, half_odd = as<R>(0.5) * value.odd;
    store(first_of_pair(k) + 1, half_even + half_odd);
    store(first_of_pair(k), half_even - half_odd);
  }

 private:
  // Without these the compiler takes the way through memory from a load to a register.
  typedef T Register __attribute__((vector_size(sizeof(R))));
  typedef T Unaligned __attribute__((vector_size(sizeof(R)), aligned(sizeof(T)), may_alias));

  [[gnu::always_inline]] R load(int i) const {
    return std::bit_cast<R>(Register(*reinterpret_cast<const Unaligned*>(source_[i] + first_)));
  }
  [[gnu::always_inline]] void store(int i, const R& value) const {
    *reinterpret_cast<Unaligned*>(source_[i] + first_) = std::bit_cast<Register>(value);
  }

  const Sources<Stencil, T>& source_;
  std::ptrdiff_t first_;
};

}  // namespace stresslet
