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
template <class Collision, class Forcing, class Stencil, class R, class Finish = AsCollided>
[[gnu::always_inline]] inline void collide(CellPopulations<Stencil, R>& f,
                                           typename Collision::template Cell<Stencil, R>& collision,
                                           const BodyForce<R>& force, const Finish& finish = {}) {
  using ForcingCell = typename Forcing::template Cell<Stencil, R>;
  const ForcingCell forcing(moments_of(f), force);
  const auto departure = [&](auto k) __attribute__((always_inline)) {
    const EvenOdd<R> target = forcing.template target<first_of_pair(k)>();
    return EvenOdd<R>{f.pair[k].even - target.even, f.pair[k].odd - target.odd};
  };
  const auto relax = [&](auto k, const EvenOdd<R>& g) __attribute__((always_inline)) {
    constexpr int i = first_of_pair(k);
    const EvenOdd<R> taken = collision.template pair<i>(g);
    EvenOdd<R> after{f.pair[k].even - taken.even, f.pair[k].odd - taken.odd};
    if constexpr (ForcingCell::adds) {
      const EvenOdd<R> added = forcing.template added<i>();
      after.even += added.even;
      after.odd += added.odd;
    }
    f.pair[k] = finish.template pair<i>(f.pair[k], after);
  };
  const auto relax_rest = [&](const R& g) __attribute__((always_inline)) {
    R after = f.rest - collision.rest(g);
    if constexpr (ForcingCell::adds) after += forcing.rest_added();
    f.rest = finish.rest(f.rest, after);
  };

  const R rest_departure = f.rest - forcing.rest_target();
  if constexpr (Collision::template Cell<Stencil, R>::whole_cell) {
    CellPopulations<Stencil, R> g;
    g.rest = rest_departure;
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) { g.pair[k] = departure(k); });
    collision.prepare(g);
    relax_rest(g.rest);
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) { relax(k, g.pair[k]); });
  } else {
    relax_rest(rest_departure);
    unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) { relax(k, departure(k)); });
  }
}

}  // namespace stresslet
