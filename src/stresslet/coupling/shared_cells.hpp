#pragma once
/// A cell covered by several particles k with solid drags alpha_k (weights/solid_drag.hpp) and solid velocities us_k.
///
/// Implicitly, each solid holds the mean velocity u of the cell:  F_k = alpha_k rho (us_k - u),  u = u* + sum F/(2
/// rho). Solved for u, with a = sum alpha_k:
///   the fluid sees one solid  us = sum alpha_k us_k / a,   B = a/(1 + a/2),   sum F = B rho (us - u*);
///   particle k gives the fluid  F_k = B_k rho (us_k - u*) + sum_j c_kj (us_k - us_j),
///   B_k = alpha_k/(1 + a/2),   c_kj = rho alpha_k alpha_j / (2 (1 + a/2)),
/// since  alpha_k (us_k - u) = B_k (us_k - u*) + alpha_k/(2 (1 + a/2)) sum_j alpha_j (us_k - us_j).
/// The force on particle k is -F_k. The second part is friction between the solids through the fluid that they share:
/// +c_kj (us_j - us_k) on k, opposite on j, never driving. Left out, results depend on tau; taken with the other
/// particle's old velocity, the particle update is unstable: it belongs into the solve for all particles.
#include <cmath>

#include "stresslet/coupling/covered_cell.hpp"
#include "stresslet/coupling/weights/solid_drag.hpp"
#include "stresslet/exec/simd.hpp"

namespace stresslet {

/// Sums over the solids in a cell, from zero.
template <class R>
struct SharedDrag {
  R drag{};          ///< a
  Vec3<R> driven{};  ///< sum alpha_k us_k

  [[gnu::always_inline]] void add(const R& solid_drag, const Vec3<R>& velocity) {
    drag += solid_drag;
    driven += solid_drag * velocity;
  }
};

/// The one solid that the fluid sees.
template <class R>
[[gnu::always_inline]] inline CoveredCell<R> covered_cell(const SharedDrag<R>& sum) {
  using std::max;
  const R least = as<R>(1e-30);
  return {weight_from_drag(sum.drag), sum.driven / max(sum.drag, least)};
}

/// B_k of one solid with drag alpha_k where all drags add up to `drag_sum`.
template <class R>
[[gnu::always_inline]] inline R share_of_weight(const R& solid_drag, const R& drag_sum) {
  return solid_drag / (as<R>(1) + as<R>(0.5) * drag_sum);
}

/// c_kj, force per relative velocity of the solids k and j; B_j is the share of j.
template <class R>
[[gnu::always_inline]] inline R shared_cell_friction(const R& density, const R& drag_k, const R& share_j) {
  return as<R>(0.5) * density * drag_k * share_j;
}

/// The rule of the thesis preset in place of the above: where the solid fractions add up to more than 1, weights B_k
/// are multiplied by this, which makes their sum 1; elsewhere they stay. us is then weighted by B_k, without friction.
inline double thesis_weight_scale(double solid_fraction_sum, double weight_sum) {
  return solid_fraction_sum > 1 ? 1 / weight_sum : 1;
}

}  // namespace stresslet
