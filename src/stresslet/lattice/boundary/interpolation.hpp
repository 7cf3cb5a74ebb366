#pragma once
/// Laws that shift a periodic row of values by a fraction of a cell: the value at position x + theta, 0 <= theta < 1,
/// from its neighbours at x - 1, x, x + 1, x + 2. Weights sum to 1, so that sums along the row are conserved; theta = 0
/// copies.
#include <array>
#include <string_view>

#include "stresslet/base/type_list.hpp"

namespace stresslet {

/// Cubic Lagrange polynomial through four points: error of fourth order, negligible diffusion.
struct CubicInterpolation {
  static constexpr std::string_view name = "cubic";
  static constexpr std::string_view summary = "cubic Lagrange, four points";
  static std::array<double, 4> weights(double theta) {
    const double a = theta + 1, b = theta, c = theta - 1, d = theta - 2;
    return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
  }
};

/// Two points, as published by Wagner & Pagonabarraga, J. Stat. Phys. 107 (2002) 521. Diffuses like theta (1 - theta)/2
/// cells squared a step, which competes with the viscosity.
struct LinearInterpolation {
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "linear, two points, as published; diffusive";
  static std::array<double, 4> weights(double theta) { return {0, 1 - theta, theta, 0}; }
};

using ShearInterpolations = TypeList<CubicInterpolation, LinearInterpolation>;

}  // namespace stresslet
