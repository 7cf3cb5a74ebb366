#pragma once
/// Holdych's operator (PhD thesis, University of Illinois at Urbana-Champaign, 2003; as quoted by Strack & Cook, Int.
/// J. Numer. Meth. Fluids 55 (2007) 103): the equilibrium of the solid's velocity in both places,
///   f' = f + (1-B) Omega + B [f_-i - f_i + feq_i(us) - feq_-i(us)],
/// which gives twice the momentum of the others, 2 B rho (us - u*).
#include <string_view>

#include "stresslet/coupling/operators/solid_contrast.hpp"

namespace stresslet {

struct Holdych {
  static constexpr std::string_view name = "holdych";
  static constexpr std::string_view summary =
      "bounce-back about the solid's velocity: twice the momentum of the others";
  static constexpr double exchange = 2;
  static constexpr double kinetic_stress_factor = -1;
  static constexpr double largest_weight = 1;
  static constexpr double core_weight = largest_weight;

  template <class Collision, class Forcing, class Populations, class R>
  [[gnu::always_inline]] static Vec3<R> collide(
      Populations& f, typename Collision::template Cell<typename Populations::Stencil, R>& rates,
      const BodyForce<R>& force, const CoveredCell<R>& solid) {
    const Finish<typename Populations::Stencil, R> finish{
        SolidContrast<typename Populations::Stencil, R>(f, force, solid), solid.weight};
    stresslet::collide<Collision, Forcing>(f, rates, force, finish);
    return as<R>(exchange) * solid.weight * finish.contrast.momentum();
  }

 private:
  template <class Stencil, class R>
  struct Finish {
    SolidContrast<Stencil, R> contrast;
    R weight;
    [[gnu::always_inline]] R rest(const R& before, const R& after) const { return after + weight * (before - after); }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& before, const EvenOdd<R>& after) const {
      const R solid_twice = contrast.template odd_sum<i>() + contrast.template odd<i>();
      return {after.even + weight * (before.even - after.even),
              after.odd + weight * (solid_twice - before.odd - after.odd)};
    }
  };
};

}  // namespace stresslet
