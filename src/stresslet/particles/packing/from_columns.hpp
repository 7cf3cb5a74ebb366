#pragma once
/// Particle state from the columns of a file, checked.
#include <cstdint>
#include <string>
#include <vector>

#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"

namespace stresslet {

/// One entry per particle. Columns after `radius` may be empty: velocities are then those of the mean flow, angular
/// velocities half its vorticity, species 0, ids the order of the rows.
struct ParticleColumns {
  std::vector<double> x, y, z, radius;
  std::vector<double> ux, uy, uz;  ///< all three or none
  std::vector<double> wx, wy, wz;  ///< all three or none
  std::vector<double> density;
  std::vector<std::int32_t> species;
  std::vector<std::int64_t> id;  ///< any distinct numbers; renamed 0 ... N-1 in ascending order
};

/// What the columns may not say.
struct ColumnLimits {
  double density = 1;             ///< where there is no density column
  double largest_overlap = 0.02;  ///< of the smaller radius
};

/// Keeps the order of the rows and brings particles outside the periodic faces back into the box. Throws InputError,
/// naming `source` and the particles (row and id), for columns of different lengths, numbers that are not finite,
/// radii or densities not positive, ids that occur twice, centres beyond a wall, and overlaps with a particle or a wall
/// that exceed the limit.
ParticleState state_from_columns(const ParticleColumns& columns, const Box& box, const ColumnLimits& limits,
                                 const std::string& source);

}  // namespace stresslet
