#pragma once
/// Collision of one cell (or one SIMD pack of cells): moments, forcing, relaxation.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

/// Replaces the incoming populations by the outgoing ones:  f' = f - Lambda (f - target) + added.
template <class Collision, class Forcing, class Stencil, class R>
void collide(CellPopulations<Stencil, R>& f, typename Collision::template Cell<Stencil, R>& collision,
             const BodyForce<R>& force) {
  using ForcingCell = typename Forcing::template Cell<Stencil, R>;
  const ForcingCell forcing(moments_of(f), force);
  const auto departure = [&](auto k) {
    const EvenOdd<R> target = forcing.template target<first_of_pair(k)>();
    return EvenOdd<R>{f.pair[k].even - target.even, f.pair[k].odd - target.odd};
  };
  const auto relax = [&](auto k, const EvenOdd<R>& g) {
    const EvenOdd<R> taken = collision.template pair<first_of_pair(k)>(g);
    f.pair[k].even -= taken.even;
    f.pair[k].odd -= taken.odd;
    if constexpr (ForcingCell::adds) {
      const EvenOdd<R> added = forcing.template added<first_of_pair(k)>();
      f.pair[k].even += added.even;
      f.pair[k].odd += added.odd;
    }
  };
  const auto relax_rest = [&](const R& g) {
    f.rest -= collision.rest(g);
    if constexpr (ForcingCell::adds) f.rest += forcing.rest_added();
  };

  const R rest_departure = f.rest - forcing.rest_target();
  if constexpr (Collision::template Cell<Stencil, R>::whole_cell) {
    CellPopulations<Stencil, R> g;
    g.rest = rest_departure;
    unroll<Stencil::pairs>([&](auto k) { g.pair[k] = departure(k); });
    collision.prepare(g);
    relax_rest(g.rest);
    unroll<Stencil::pairs>([&](auto k) { relax(k, g.pair[k]); });
  } else {
    relax_rest(rest_departure);
    unroll<Stencil::pairs>([&](auto k) { relax(k, departure(k)); });
  }
}

}  // namespace stresslet
