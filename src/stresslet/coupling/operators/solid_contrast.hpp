#pragma once
/// The coupling operators of partially saturated cells, and what they have in common.
///
/// Notation: f incoming populations, rho = sum f, F body force, u* = (sum f c + F/2)/rho, us the solid's velocity, B
/// its weight, Omega what the fluid's collision (with the body force) adds, index -i the opposite of i.
///   superposition   f' = f + Omega + B [feq(us) - feq(u*)]                                          B in [0, 2]
///   guo-form        f' = f + Omega with the force B rho (us - u*) added to the body force            B in [0, 2]
///   bounce-back     f' = f + (1-B) Omega + B [f_-i - f_i + feq_i(us) - feq_-i(u*)]                   B in [0, 1]
///   half-holdych    f' = f + (1-B) Omega + B/2 [f_-i - f_i + feq_i(us) - feq_-i(us) + 3 w c.F]       B in [0, 1]
///   holdych         f' = f + (1-B) Omega + B [f_-i - f_i + feq_i(us) - feq_-i(us)]                   B in [0, 1]
/// Use superposition if unsure. All keep the mass, change nothing where f = feq(us) without body force, and give the
/// fluid, besides F, the momentum
///   exchange B rho (us - u*),   exchange = 1, holdych 2;
/// the force on the particle is the opposite. The last three let cells relax their stress with the rate (1-B)/tau and
/// so carry the kinetic stress of kinetic_stress.hpp, which belongs to the particle.
///
/// Pattern of an operator: `name`, `summary`, `exchange`, `kinetic_stress_factor`, `largest_weight`, `core_weight` (the
/// largest in the core of a sphere, covered_runs.hpp), and `collide<Collision, Forcing>(f, rates, force, solid)`, which
/// replaces f by f' and returns the momentum given. No branch: cells with B = 0 come out as from the fluid's collision.
#include "stresslet/coupling/covered_cell.hpp"
#include "stresslet/lattice/collide.hpp"

namespace stresslet {

/// What all operators compute of a cell. The difference of equilibria that they need,
///   feq_i(us) - feq_i(u*) = w_i rho [3 c.d + 9/2 (c.d)(c.s) - 3/2 d.s],   d = us - u*,  s = us + u*,
/// is kept in this form: it has the momentum rho d to round-off and needs few registers.
template <class Stencil, class R>
class SolidContrast {
 public:
  template <class Populations>
  [[gnu::always_inline]] SolidContrast(const Populations& f, const BodyForce<R>& force, const CoveredCell<R>& solid) {
    const Moments<R> m = moments_of(f);
    const R density = m.density();
    const Vec3<R> fluid_velocity = (m.momentum + as<R>(0.5) * force.density) / density;
    momentum_ = density * (solid.velocity - fluid_velocity);
    sum_ = solid.velocity + fluid_velocity;
    density_ = density;
    product_ = dot(momentum_, sum_);
  }

  /// rho (us - u*).
  const Vec3<R>& momentum() const { return momentum_; }

  [[gnu::always_inline]] R rest() const { return as<R>(-1.5 * Stencil::weight[0]) * product_; }
  /// Even part of feq(us) - feq(u*).
  template <int i>
  [[gnu::always_inline]] R even() const {
    constexpr double w = Stencil::weight[i];
    return as<R>(2 * w) * (as<R>(4.5) * along<Stencil, i>(momentum_) * along<Stencil, i>(sum_) - as<R>(1.5) * product_);
  }
  /// Odd part of feq(us) - feq(u*).
  template <int i>
  [[gnu::always_inline]] R odd() const {
    return as<R>(6 * Stencil::weight[i]) * along<Stencil, i>(momentum_);
  }
  /// Odd part of feq(us) + feq(u*).
  template <int i>
  [[gnu::always_inline]] R odd_sum() const {
    return as<R>(6 * Stencil::weight[i]) * (density_ * along<Stencil, i>(sum_));
  }

 private:
  Vec3<R> momentum_, sum_;
  R density_, product_;
};

}  // namespace stresslet
