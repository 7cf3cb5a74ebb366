#pragma once
/// Superposition of the fluid's collision and a pull of the equilibrium towards the solid's velocity: Noble &
/// Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189, their other collision term, f' = feq(us) + (1 - 1/tau) (f - feq(u*))
/// at B = 1, with the fluid's collision left whole:
///   f' = f + Omega + B [feq(us) - feq(u*)].
/// The added part is Guo's source term of the force B rho (us - u*) at the velocity (us + u*)/2, unrelaxed.
#include <string_view>

#include "stresslet/coupling/operators/solid_contrast.hpp"

namespace stresslet {

struct Superposition {
  static constexpr std::string_view name = "superposition";
  static constexpr std::string_view summary =
      "equilibrium pulled towards the solid's velocity, viscous stress untouched";
  static constexpr double exchange = 1;
  static constexpr double kinetic_stress_factor = 0;
  static constexpr double largest_weight = 2;
  static constexpr double core_weight = largest_weight;

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
    [[gnu::always_inline]] R rest(const R& /*before*/, const R& after) const {
      return after + weight * contrast.rest();
    }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& /*before*/, const EvenOdd<R>& after) const {
      return {after.even + weight * contrast.template even<i>(), after.odd + weight * contrast.template odd<i>()};
    }
  };
};

}  // namespace stresslet
