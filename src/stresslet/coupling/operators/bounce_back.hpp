#pragma once
/// Bounce-back of the non-equilibrium part: Noble & Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189:
///   f' = f + (1-B) Omega + B [f_-i - f_i + feq_i(us) - feq_-i(u*)].
/// Solid cells do not relax their stress, hence the kinetic stress -B Pi_neq besides the usual first moment.
#include <string_view>

#include "stresslet/coupling/operators/solid_contrast.hpp"

namespace stresslet {

struct NonEquilibriumBounceBack {
  static constexpr std::string_view name = "bounce-back";
  static constexpr std::string_view summary = "non-equilibrium part bounced back; cells keep their stress";
  static constexpr double exchange = 1;
  static constexpr double kinetic_stress_factor = -1;
  static constexpr double largest_weight = 1;

  template <class Collision, class Forcing, class Populations, class R>
  [[gnu::always_inline]] static Vec3<R> collide(
      Populations& f, typename Collision::template Cell<typename Populations::Stencil, R>& rates,
      const BodyForce<R>& force, const CoveredCell<R>& solid) {
    const Finish<typename Populations::Stencil, R> finish{
        SolidContrast<typename Populations::Stencil, R>(f, force, solid), solid.weight};
    stresslet::collide<Collision, Forcing>(f, rates, force, finish);
    return solid.weight * finish.contrast.momentum();
  }

 private:
  template <class Stencil, class R>
  struct Finish {
    SolidContrast<Stencil, R> contrast;
    R weight;
    [[gnu::always_inline]] R rest(const R& before, const R& after) const {
      return after + weight * (before - after + contrast.rest());
    }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& before, const EvenOdd<R>& after) const {
      return {after.even + weight * (before.even - after.even + contrast.template even<i>()),
              after.odd + weight * (contrast.template odd_sum<i>() - before.odd - after.odd)};
    }
  };
};

}  // namespace stresslet
