#include "stresslet/coupling/sphere_images.hpp"

#include <cmath>

namespace stresslet {

namespace {

/// Whether a sphere at `centre` reaches a cell of [0, n).
bool reaches(double centre, double touch_radius, int n) {
  return centre + touch_radius > -0.5 && centre - touch_radius < n - 0.5;
}

}  // namespace

void append_images(const Grid& grid, const ResolvedSphere& sphere, std::int32_t index, double touch_radius,
                   double shear_offset, double shear_velocity, std::vector<SphereImage>& images) {
  const auto shifts = [&](int axis) { return grid.closure[std::size_t(axis)] == Closure::open ? 0 : 1; };
  for (int kz = -shifts(2); kz <= shifts(2); ++kz) {
    const double z = sphere.centre.z + kz * grid.size[2];
    if (!reaches(z, touch_radius, grid.size[2])) continue;
    for (int ky = -shifts(1); ky <= shifts(1); ++ky) {
      const double y = sphere.centre.y + ky * grid.size[1];
      if (!reaches(y, touch_radius, grid.size[1])) continue;
      const bool sheared = grid.closure[1] == Closure::sheared;
      const double x0 = sphere.centre.x + (sheared ? ky * shear_offset : 0);
      const double nx = grid.size[0], first = shifts(0) ? x0 - nx * std::floor((x0 + 0.5) / nx) : x0;
      for (int kx = -shifts(0); kx <= shifts(0); ++kx) {
        const double x = first + kx * nx;
        if (!reaches(x, touch_radius, grid.size[0])) continue;
        images.push_back({index, {x, y, z}, sphere.radius, sheared ? ky * shear_velocity : 0});
      }
    }
  }
}

}  // namespace stresslet
