#pragma once
/// Three-dimensional, 19 velocities: the main one.
#include <string_view>

#include "stresslet/lattice/stencil/velocity_set.hpp"

namespace stresslet {

struct D3Q19 : VelocitySet<3, 2, 19> {
  static constexpr std::string_view name = "D3Q19";
  static constexpr std::string_view summary = "three-dimensional, 19 velocities: the main one";
  static constexpr std::array<Velocity, size> velocity = velocities();
  static constexpr std::array<double, size> weight = [] {
    constexpr double of_length[] = {1.0 / 3, 1.0 / 18, 1.0 / 36};
    std::array<double, size> weights{};
    for (int i = 0; i < size; ++i) weights[i] = of_length[squared_length(velocity[i])];
    return weights;
  }();
};
static_assert(is_isotropic<D3Q19>());

}  // namespace stresslet
