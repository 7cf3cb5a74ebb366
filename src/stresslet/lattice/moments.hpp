#pragma once
/// What one cell holds, and its local equilibrium. Populations are stored as deviations from the rest state,
/// f_i - w_i, which keeps the digits that single precision would lose against w_i.
///
/// Most laws work on pairs of opposite populations: `even` = f_i + f_opposite, `odd` = f_i - f_opposite, i the first of
/// the pair. With them  sum f = f_0 + sum even,  sum f c = sum odd c.
///
/// Equilibrium, second order in the velocity (Qian, d'Humieres & Lallemand, Europhys. Lett. 17 (1992) 479):
///   feq_i = w_i [rho + rho (3 c.u + 9/2 (c.u)^2 - 3/2 u^2)],   speed of sound squared 1/3.
#include <array>
#include <type_traits>
#include <utility>

#include "stresslet/base/unroll.hpp"
#include "stresslet/base/value.hpp"
#include "stresslet/base/vec3.hpp"
#include "stresslet/lattice/stencil/velocity_set.hpp"

namespace stresslet {

template <class R>
struct EvenOdd {
  R even, odd;
};

/// The first population of pair `k`.
constexpr int first_of_pair(int k) { return 2 * k + 1; }

/// c_i . a, without multiplications.
template <class Stencil, int i, class R>
[[gnu::always_inline]] inline R along(const Vec3<R>& a) {
  constexpr auto c = Stencil::velocity[i];
  const auto add = [](const R& sum, const R& term, auto sign) {
    if constexpr (sign.value > 0)
      return R(sum + term);
    else
      return R(sum - term);
  };
  if constexpr (c[0] != 0) {
    R sum = c[0] > 0 ? a.x : -a.x;
    if constexpr (c[1] != 0) sum = add(sum, a.y, std::integral_constant<int, c[1]>{});
    if constexpr (c[2] != 0) sum = add(sum, a.z, std::integral_constant<int, c[2]>{});
    return sum;
  } else if constexpr (c[1] != 0) {
    R sum = c[1] > 0 ? a.y : -a.y;
    if constexpr (c[2] != 0) sum = add(sum, a.z, std::integral_constant<int, c[2]>{});
    return sum;
  } else if constexpr (c[2] != 0) {
    return c[2] > 0 ? a.z : -a.z;
  } else {
    return as<R>(0);
  }
}

/// The populations of one cell, as the rest population and pairs.
///
/// Functions of populations take whatever has these four members, so that a kernel may leave populations in memory
/// until a pair is needed: nineteen packs do not fit the registers.
template <class Stencil_, class R>
struct CellPopulations {
  using Stencil = Stencil_;
  R rest;
  std::array<EvenOdd<R>, Stencil::pairs> pair;

  [[gnu::always_inline]] const R& read_rest() const { return rest; }
  template <int k>
  [[gnu::always_inline]] const EvenOdd<R>& read() const {
    return pair[k];
  }
  [[gnu::always_inline]] void write_rest(const R& value) { rest = value; }
  template <int k>
  [[gnu::always_inline]] void write(const EvenOdd<R>& value) {
    pair[k] = value;
  }
};

/// Density over the rest state, and momentum density.
template <class R>
struct Moments {
  R density_deviation;
  Vec3<R> momentum;

  R density() const { return as<R>(1) + density_deviation; }
};

/// The pairs whose first population moves along `axis` in the direction of `sign`.
template <class Stencil, int axis, int sign>
struct PairsAlong {
  static constexpr auto found = [] {
    std::pair<std::array<int, Stencil::pairs>, int> list{};
    for (int k = 0; k < Stencil::pairs; ++k)
      if (Stencil::velocity[first_of_pair(k)][axis] == sign) list.first[list.second++] = k;
    return list;
  }();
  static constexpr int count = found.second;
  static constexpr int pair(int n) { return found.first[n]; }
};

/// Component `axis` of sum f c.
template <int axis, class Populations>
[[gnu::always_inline]] inline auto momentum_along(const Populations& f) {
  using Stencil = typename Populations::Stencil;
  using Forwards = PairsAlong<Stencil, axis, 1>;
  using Backwards = PairsAlong<Stencil, axis, -1>;
  auto sum = tree_sum<0, Forwards::count>([&](auto n) __attribute__((always_inline)) {
    return f.template read<Forwards::pair(n)>().odd;
  });
  if constexpr (Backwards::count > 0)
    sum -= tree_sum<0, Backwards::count>([&](auto n) __attribute__((always_inline)) {
      return f.template read<Backwards::pair(n)>().odd;
    });
  return sum;
}

template <class Populations>
[[gnu::always_inline]] inline auto moments_of(const Populations& f) {
  using Stencil = typename Populations::Stencil;
  auto moving =
      tree_sum<0, Stencil::pairs>([&](auto k) __attribute__((always_inline)) { return f.template read<k>().even; });
  using R = decltype(moving);
  R z = as<R>(0);
  if constexpr (Stencil::dimensions == 3) z = momentum_along<2>(f);
  return Moments<R>{f.read_rest() + moving, {momentum_along<0>(f), momentum_along<1>(f), z}};
}

/// sum g c c over all populations; of deviations from the rest state, where g are populations.
template <class Populations>
[[gnu::always_inline]] inline auto second_moment(const Populations& g) {
  using Stencil = typename Populations::Stencil;
  using R = std::decay_t<decltype(g.read_rest())>;
  const R zero = as<R>(0);
  SymTensor3<R> p{zero, zero, zero, zero, zero, zero};
  unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
    constexpr auto c = Stencil::velocity[first_of_pair(k)];
    const R even = g.template read<k>().even;
    if constexpr (c[0] != 0) p.xx += even;
    if constexpr (c[1] != 0) p.yy += even;
    if constexpr (c[2] != 0) p.zz += even;
    if constexpr (c[0] * c[1] > 0) p.xy += even;
    if constexpr (c[0] * c[1] < 0) p.xy -= even;
    if constexpr (c[0] * c[2] > 0) p.xz += even;
    if constexpr (c[0] * c[2] < 0) p.xz -= even;
    if constexpr (c[1] * c[2] > 0) p.yz += even;
    if constexpr (c[1] * c[2] < 0) p.yz -= even;
  });
  return p;
}

/// Equilibrium of one cell, as deviations from the rest state.
template <class Stencil, class R>
class Equilibrium {
 public:
  Equilibrium(const R& density_deviation, const Vec3<R>& velocity)
      : velocity_(velocity),
        density_(as<R>(1) + density_deviation),
        isotropic_(density_deviation - as<R>(1.5) * density_ * dot(velocity, velocity)) {}

  [[gnu::always_inline]] R rest() const { return as<R>(Stencil::weight[0]) * isotropic_; }

  /// Sum and difference of the pair whose first population is `i`.
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> pair() const {
    constexpr double w = Stencil::weight[i];
    const R cu = along<Stencil, i>(velocity_);
    const R density_cu = density_ * cu;
    return {as<R>(2 * w) * (isotropic_ + as<R>(4.5) * (density_cu * cu)), as<R>(6 * w) * density_cu};
  }

  const Vec3<R>& velocity() const { return velocity_; }
  const R& density() const { return density_; }

 private:
  Vec3<R> velocity_;
  R density_, isotropic_;
};

}  // namespace stresslet
