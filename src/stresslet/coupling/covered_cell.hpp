#pragma once
/// What a collision must know of the solid in a cell, or in one SIMD pack of cells.
#include "stresslet/base/vec3.hpp"

namespace stresslet {

template <class R>
struct CoveredCell {
  R weight;          ///< solid weight B; 0 in fluid
  Vec3<R> velocity;  ///< us of the solid at the cell centre; any finite value where B = 0
};

/// us = U + w x r, r from the particle's centre to the cell's. Linear in r: along a row of cells it changes by
/// (0, w_z, -w_y) from cell to cell.
template <class R>
[[gnu::always_inline]] inline Vec3<R> rigid_velocity(const Vec3<R>& velocity, const Vec3<R>& angular_velocity,
                                                     const Vec3<R>& arm) {
  return velocity + cross(angular_velocity, arm);
}

}  // namespace stresslet
