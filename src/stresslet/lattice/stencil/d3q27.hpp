#pragma once
/// Three-dimensional, all 27 velocities: the most isotropic, 40 % dearer.
#include <string_view>

#include "stresslet/lattice/stencil/velocity_set.hpp"

namespace stresslet {

struct D3Q27 : VelocitySet<3, 3, 27> {
  static constexpr std::string_view name = "D3Q27";
  static constexpr std::string_view summary = "three-dimensional, all 27 velocities: the most isotropic, 40 % dearer";
  static constexpr std::array<Velocity, size> velocity = velocities();
  static constexpr std::array<double, size> weight = [] {
    constexpr double of_length[] = {8.0 / 27, 2.0 / 27, 1.0 / 54, 1.0 / 216};
    std::array<double, size> weights{};
    for (int i = 0; i < size; ++i) weights[i] = of_length[squared_length(velocity[i])];
    return weights;
  }();
};
static_assert(is_isotropic<D3Q27>());

}  // namespace stresslet
