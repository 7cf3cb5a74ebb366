#pragma once
/// Below l cells the force of the film less what it is at l:  F_corr = F(h) - F(l), h < l. Najuch (2018), ch. 4.
#include <algorithm>
#include <string_view>

namespace stresslet {

struct HardCutOff {
  static constexpr std::string_view name = "hard-cut-off";
  static constexpr std::string_view summary = "films are resolved down to l cells, not at all below";

  template <class R>
  static R resolved_gap(const R& gap, const R& length) {
    using std::max;
    return max(gap, length);
  }
};

}  // namespace stresslet
