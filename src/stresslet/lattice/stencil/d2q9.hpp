#pragma once
/// Flow in the plane of x and y, one cell deep.
#include <string_view>

#include "stresslet/lattice/stencil/velocity_set.hpp"

namespace stresslet {

struct D2Q9 : VelocitySet<2, 2, 9> {
  static constexpr std::string_view name = "D2Q9";
  static constexpr std::string_view summary = "flow in the plane of x and y, one cell deep";
  static constexpr std::array<Velocity, size> velocity = velocities();
  static constexpr std::array<double, size> weight = [] {
    constexpr double of_length[] = {4.0 / 9, 1.0 / 9, 1.0 / 36};
    std::array<double, size> weights{};
    for (int i = 0; i < size; ++i) weights[i] = of_length[squared_length(velocity[i])];
    return weights;
  }();
};
static_assert(is_isotropic<D2Q9>());

}  // namespace stresslet
