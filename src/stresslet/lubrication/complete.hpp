#pragma once
/// All modes: squeezing, sliding and relative spin. Coefficients per unit viscosity, lambda = a2/a1,
/// xi = 2 gap/(a1 + a2), L = ln(1/xi), from the singular resistance functions:
///   X = 6 pi a1 [ 2 l^2/(1+l)^3 / xi + l (1 + 7 l + l^2)/(5 (1+l)^3) L ]       = X^A_11
///   Y = 8 pi/5 a1 l (2 + l + 2 l^2)/(1+l)^3 L                                   = Y^A_11
///   B = -16 pi/5 a1^2 l (1 - l)/(1 + l) L                                       = Y^B_11 - Y^B_21
///   C = 8 pi/5 a1^3 l (2 - l + 2 l^2)/(1 + l) L                                 = (a1+a2) B + 2 (Y^C_11 - Y^C_12)
/// Valid for xi < 1. Source: docs/theory.md; simplified form of Najuch (2018), eqs. 5.7-5.8, corrected.
#include <string_view>

#include "stresslet/lubrication/pair_law.hpp"

namespace stresslet {

struct Complete {
  static constexpr std::string_view name = "complete";
  static constexpr std::string_view summary = "squeezing, sliding and relative spin, exactly balanced and dissipative";
  static constexpr bool sees_background = false;

  template <class R>
  [[gnu::always_inline]] static PairResistance<R> resistance(const R& a1, const R& a2, const R& gap) {
    const R l = a2 / a1;
    const R m = R(1) / (R(1) + l);
    const R m3 = m * m * m;
    const R xi = R(2) * gap / (a1 + a2);
    const R log = -natural_log(xi);
    const R l2 = l * l;
    return {R(6 * pi) * a1 * m3 * (R(2) * l2 / xi + R(0.2) * l * (R(1) + R(7) * l + l2) * log),
            R(8 * pi / 5) * a1 * l * (R(2) + l + R(2) * l2) * m3 * log,
            R(-16 * pi / 5) * a1 * a1 * l * (R(1) - l) * m * log,
            R(8 * pi / 5) * a1 * a1 * a1 * l * (R(2) - l + R(2) * l2) * m * log};
  }

  template <class R>
  static R arm(const R&, const R&, const R& centre_distance) {
    return centre_distance;
  }
};

}  // namespace stresslet
