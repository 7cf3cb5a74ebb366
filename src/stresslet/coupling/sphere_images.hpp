#pragma once
/// Spheres as the lattice meets them: every periodic or sheared image that reaches into the domain. Lengths in cells,
/// cell i centred on coordinate i, velocities in lattice units.
#include <cstdint>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/lattice/grid.hpp"

namespace stresslet {

struct ResolvedSphere {
  Vec3<double> centre{};
  double radius = 0;
  Vec3<double> velocity{}, angular_velocity{};
};

struct SphereImage {
  std::int32_t sphere;
  Vec3<double> centre;
  double radius;         ///< as drawn on the grid
  double velocity_jump;  ///< along x: velocity of the image minus that of the sphere

  friend bool operator==(const SphereImage&, const SphereImage&) = default;
};

/// The images of sphere `index`, in a fixed order. `touch_radius` bounds what it covers; the image above a sheared face
/// is displaced by `shear_offset` and faster by `shear_velocity`.
void append_images(const Grid& grid, const ResolvedSphere& sphere, std::int32_t index, double touch_radius,
                   double shear_offset, double shear_velocity, std::vector<SphereImage>& images);

}  // namespace stresslet
