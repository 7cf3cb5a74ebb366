#pragma once
/// The grid takes a film of thickness h for one of h' = sqrt(h^2 + l^2):
///   F_corr = F(h) - F(sqrt(h^2 + l^2)),   of a logarithmic mode  1/2 ln(1 + l^2/h^2).
/// Smooth in the gap, no switch at which the force kinks. Use this if unsure.
///
/// Pattern of a sub-grid law: `resolved_gap` >= gap, what the grid resolves of a film, from the length of the mode.
///   law             h'                 beyond l
///   soft-cut-off    sqrt(h^2 + l^2)    falls as (l/h)^2 of the film's own force
///   hard-cut-off    max(h, l)          zero
/// Lengths in cells. Source: docs/theory.md.
#include <cmath>
#include <string_view>

namespace stresslet {

struct SoftCutOff {
  static constexpr std::string_view name = "soft-cut-off";
  static constexpr std::string_view summary = "a film of thickness h is resolved as one of sqrt(h^2 + l^2)";

  template <class R>
  static R resolved_gap(const R& gap, const R& length) {
    using std::sqrt;
    return sqrt(gap * gap + length * length);
  }
};

}  // namespace stresslet
