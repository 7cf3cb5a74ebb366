#pragma once
/// Dry spheres: no pair lubrication.
#include <string_view>

#include "stresslet/lubrication/pair_law.hpp"

namespace stresslet {

struct NoLubrication {
  static constexpr std::string_view name = "none";
  static constexpr std::string_view summary = "no pair lubrication (dry spheres)";
  static constexpr bool sees_background = false;

  template <class R>
  static PairResistance<R> resistance(const R&, const R&, const R&) {
    return {R(0), R(0), R(0), R(0)};
  }

  template <class R>
  static R arm(const R&, const R&, const R& centre_distance) {
    return centre_distance;
  }
};

}  // namespace stresslet
