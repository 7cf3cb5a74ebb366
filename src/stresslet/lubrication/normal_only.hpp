#pragma once
/// Squeezing only: X of `Complete`, no resistance to sliding and spin.
#include <string_view>

#include "stresslet/lubrication/complete.hpp"

namespace stresslet {

struct NormalOnly {
  static constexpr std::string_view name = "normal";
  static constexpr std::string_view summary = "squeezing only";
  static constexpr bool sees_background = false;

  template <class R>
  static PairResistance<R> resistance(const R& a1, const R& a2, const R& gap) {
    return {Complete::resistance(a1, a2, gap).X, R(0), R(0), R(0)};
  }

  template <class R>
  static R arm(const R&, const R&, const R& centre_distance) {
    return centre_distance;
  }
};

}  // namespace stresslet
