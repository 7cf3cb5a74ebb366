#pragma once
/// Exact difference method: Kupershtokh, Medvedev & Karpov, Comput. Math. Appl. 58 (2009) 965, eq. 8:
///   f' = f - Lambda (f - feq(v)) + feq(v + F/rho) - feq(v),   v = sum f c / rho.
/// The equilibrium shifts by what the force does in a step. Momentum flux too large by F F / (4 rho) at any relaxation
/// time: a constant under a uniform force, -div(F F / 4 rho) of spurious force where F varies.
/// The velocity is v + F/(2 rho), as with the other laws.
#include "stresslet/lattice/forcing/no_force.hpp"

namespace stresslet {

template <class Stencil, class R>
class ExactDifferenceCell {
 public:
  static constexpr bool adds = true;
  ExactDifferenceCell(const Moments<R>& m, const BodyForce<R>& force)
      : before_(m.density_deviation, m.momentum / m.density()),
        after_(m.density_deviation, (m.momentum + force.density) / m.density()) {}

  [[gnu::always_inline]] R rest_target() const { return before_.rest(); }
  [[gnu::always_inline]] R rest_added() const { return after_.rest() - before_.rest(); }

  template <int i>
  [[gnu::always_inline]] EvenOdd<R> target() const {
    return before_.template pair<i>();
  }
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> added() const {
    const auto a = after_.template pair<i>(), b = before_.template pair<i>();
    return {a.even - b.even, a.odd - b.odd};
  }

 private:
  Equilibrium<Stencil, R> before_, after_;
};

struct ExactDifference {
  static constexpr std::string_view name = "exact-difference";
  static constexpr std::string_view summary = "Kupershtokh 2009: equilibrium shifted along the force";
  template <class Stencil, class R>
  using Cell = ExactDifferenceCell<Stencil, R>;
};

}  // namespace stresslet
