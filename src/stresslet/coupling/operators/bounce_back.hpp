#pragma once
/// Bounce-back of the non-equilibrium part: Noble & Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189:
///   f' = f + (1-B) Omega + B [f_-i - f_i + feq_i(us) - feq_-i(u*)].
/// Solid cells do not relax their stress, hence the kinetic stress -B Pi_neq besides the usual first moment.
///
/// Nothing damps a disturbance in a cell of B = 1, and the velocities of the solid make it grow: by up to 4 U^2 a step
/// in a solid that moves at U (largest eigenvalue of one linear step over all wave vectors, the same for any relaxation
/// time), by the square of the velocity difference where a sheared plane cuts a sphere. A suspension ends so within a
/// strain of 1 or 2. Hence the core of a sphere has a little less: the sums over a sphere at rest change by 2e-4.
#include <string_view>

#include "stresslet/coupling/operators/solid_contrast.hpp"

namespace stresslet {

struct NonEquilibriumBounceBack {
  static constexpr std::string_view name = "bounce-back";
  static constexpr std::string_view summary = "non-equilibrium part bounced back; cells keep their stress";
  static constexpr double exchange = 1;
  static constexpr double kinetic_stress_factor = -1;
  static constexpr double largest_weight = 1;
  static constexpr double core_weight = 0.95;

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
