#pragma once
/// Collision of one cell (or one SIMD pack of cells): moments, forcing, relaxation.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

/// What becomes of a collision in plain fluid: nothing more.
struct AsCollided {
  template <class R>
  R rest(const R& /*before*/, const R& after) const {
    return after;
  }
  template <int i, class R>
  EvenOdd<R> pair(const EvenOdd<R>& /*before*/, const EvenOdd<R>& after) const {
    return after;
  }
};

/// Replaces the incoming populations by the outgoing ones:  f' = f - Lambda (f - target) + added, handed through
/// `finish` pair by pair together with f, for cells that are not all fluid.
template <class Collision, class Forcing, class Populations, class R, class Finish = AsCollided>
[[gnu::always_inline]] inline void collide(
    Populations& f, typename Collision::template Cell<typename Populations::Stencil, R>& collision,
    const BodyForce<R>& force, const Finish& finish = {}) {
  using Stencil = typename Populations::Stencil;
  using CollisionCell = typename Collision::template Cell<Stencil, R>;
  using ForcingCell = typename Forcing::template Cell<Stencil, R>;
  const ForcingCell forcing(moments_of(f), force);
  const auto departure = [&](auto k) __attribute__((always_inline)) {
    const EvenOdd<R> before = f.template read<k>(), target = forcing.template target<first_of_pair(k)>();
    return EvenOdd<R>{before.even - target.even, before.odd - target.odd};
  };
  if constexpr (CollisionCell::whole_cell) {
    CellPopulations<Stencil, R> g;
    g.rest = f.read_rest() - forcing.rest_target();
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) { g.pair[k] = departure(k); });
    collision.prepare(g);
  }

  const R rest = f.read_rest();
  R rest_after = rest - collision.rest(rest - forcing.rest_target());
  if constexpr (ForcingCell::adds) rest_after += forcing.rest_added();
  f.write_rest(finish.rest(rest, rest_after));

  unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
    constexpr int i = first_of_pair(k);
    const EvenOdd<R> before = f.template read<k>(), taken = collision.template pair<i>(departure(k));
    EvenOdd<R> after{before.even - taken.even, before.odd - taken.odd};
    if constexpr (ForcingCell::adds) {
      const EvenOdd<R> added = forcing.template added<i>();
      after.even += added.even;
      after.odd += added.odd;
    }
    f.template write<k>(finish.template pair<i>(before, after));
  });
}

}  // namespace stresslet
