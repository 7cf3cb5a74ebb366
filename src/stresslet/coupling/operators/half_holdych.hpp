#pragma once
/// Holdych's operator with the factor 1/2 that gives it the momentum of the others (Najuch, PhD thesis, University of
/// Edinburgh, 2018, appendix A):
///   f' = f + (1-B) Omega + B/2 [f_-i - f_i + feq_i(us) - feq_-i(us) + 3 w c.F].
/// The half would also take away half the body force F; the last term, which is not in the thesis, puts it back.
#include <string_view>

#include "stresslet/coupling/operators/solid_contrast.hpp"

namespace stresslet {

struct HalfHoldych {
  static constexpr std::string_view name = "half-holdych";
  static constexpr std::string_view summary = "half of holdych: the momentum of the others";
  static constexpr double exchange = 1;
  static constexpr double kinetic_stress_factor = -1;
  static constexpr double largest_weight = 1;
  static constexpr double core_weight = largest_weight;

  template <class Collision, class Forcing, class Populations, class R>
  [[gnu::always_inline]] static Vec3<R> collide(
      Populations& f, typename Collision::template Cell<typename Populations::Stencil, R>& rates,
      const BodyForce<R>& force, const CoveredCell<R>& solid) {
    const Finish<typename Populations::Stencil, R> finish{
        SolidContrast<typename Populations::Stencil, R>(f, force, solid), solid.weight, force.density};
    stresslet::collide<Collision, Forcing>(f, rates, force, finish);
    return solid.weight * finish.contrast.momentum();
  }

 private:
  template <class Stencil, class R>
  struct Finish {
    SolidContrast<Stencil, R> contrast;
    R weight;
    Vec3<R> force;
    [[gnu::always_inline]] R rest(const R& before, const R& after) const { return after + weight * (before - after); }
    template <int i>
    [[gnu::always_inline]] EvenOdd<R> pair(const EvenOdd<R>& before, const EvenOdd<R>& after) const {
      const R solid = as<R>(0.5) * (contrast.template odd_sum<i>() + contrast.template odd<i>());
      const R half_force = as<R>(3 * Stencil::weight[i]) * along<Stencil, i>(force);
      return {after.even + weight * (before.even - after.even), after.odd + weight * (solid - after.odd + half_force)};
    }
  };
};

}  // namespace stresslet
