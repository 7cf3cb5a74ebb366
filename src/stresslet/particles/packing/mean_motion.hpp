#pragma once
/// Motion of particles carried by the mean flow, without peculiar velocity.
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"

namespace stresslet {

/// Angular velocity of a free sphere in the mean flow: half the vorticity.
inline Vec3<double> mean_angular_velocity(const Box& box) { return {0, 0, -0.5 * box.mean_gradient()}; }

inline void move_with_mean_flow(ParticleState& state, const Box& box) {
  for (std::size_t i = 0; i < state.size(); ++i) {
    state.set_velocity(i, {box.mean_flow(state.y[i]), 0, 0});
    state.set_angular_velocity(i, mean_angular_velocity(box));
  }
}

}  // namespace stresslet
