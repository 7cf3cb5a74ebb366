#pragma once
/// Two names for how firmly a solid holds the fluid of its cell. The collision of a cell changes its momentum by
///   F = B rho (us - u*) = alpha rho (us - u),
/// u* the velocity before, u = u* + F/(2 rho) the mean of before and after. B is the solid weight (explicit form),
/// alpha the solid drag (implicit form, the one that adds up where solids share a cell):
///   alpha = B/(1 - B/2),  B = alpha/(1 + alpha/2),  0 <= B < 2,  0 <= alpha.
#include "stresslet/base/value.hpp"

namespace stresslet {

template <class R>
[[gnu::always_inline]] inline R weight_from_drag(const R& drag) {
  return drag / (as<R>(1) + as<R>(0.5) * drag);
}

template <class R>
[[gnu::always_inline]] inline R drag_from_weight(const R& weight) {
  return weight / (as<R>(1) - as<R>(0.5) * weight);
}

}  // namespace stresslet
