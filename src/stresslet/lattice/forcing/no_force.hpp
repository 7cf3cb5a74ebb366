#pragma once
/// The forcing law of a fluid on which no force acts. Also the pattern of a forcing law; docs/theory.md, "Body forces",
/// compares the family: "guo" if unsure.
///
/// A law is made once per cell from the moments of the streamed populations and gives the populations the collision
/// relaxes towards (`rest_target`, `target<i>`) and those it adds unrelaxed (`rest_added`, `added<i>`):
///   f' = f - Lambda (f - target) + added,   Lambda the relaxation operator of the collision law.
/// A law may name another cell, `Reading`, whose target the strain rate is read against (cell_state.hpp).
/// Macroscopic velocity for every law: u = (sum f c + F/2) / rho.
#include <string_view>

#include "stresslet/lattice/moments.hpp"

namespace stresslet {

/// A uniform force density, lattice units, and the relaxation rate of momentum-carrying (odd) populations.
template <class R>
struct BodyForce {
  Vec3<R> density;
  R odd_rate;
};

template <class Stencil, class R>
class NoForceCell {
 public:
  static constexpr bool adds = false;
  NoForceCell(const Moments<R>& m, const BodyForce<R>&) : equilibrium_(m.density_deviation, m.momentum / m.density()) {}

  [[gnu::always_inline]] R rest_target() const { return equilibrium_.rest(); }
  template <int i>
  [[gnu::always_inline]] EvenOdd<R> target() const {
    return equilibrium_.template pair<i>();
  }

 private:
  Equilibrium<Stencil, R> equilibrium_;
};

struct NoForce {
  static constexpr std::string_view name = "none";
  static constexpr std::string_view summary = "no body force";
  template <class Stencil, class R>
  using Cell = NoForceCell<Stencil, R>;
};

}  // namespace stresslet
