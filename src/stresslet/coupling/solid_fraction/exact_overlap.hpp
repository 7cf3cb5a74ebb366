#pragma once
/// The exact volume that a sphere and a unit cube share: the reference of the other laws, good to 1e-12 for radii up to
/// 50 cells. The area that a disc and a square share is known in closed form; it is integrated over the height of the
/// cube, piece by piece between the heights where the disc's edge passes a side or a corner of the square. Within a
/// piece z = middle - half cos(theta) takes away the square roots at the ends, and Gauss-Legendre points in theta
/// converge exponentially; pieces that have not converged are halved. Slow: some hundred areas a cell.
#include <string_view>

#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/simd.hpp"

namespace stresslet {

/// `offset` points from the sphere's centre to the cube's.
double sphere_cube_overlap(const Vec3<double>& offset, double radius);

struct ExactOverlap {
  static constexpr std::string_view name = "exact";
  static constexpr std::string_view summary = "exact overlap of sphere and cube: the reference, slow";

  double fraction(const Vec3<double>& offset, double radius) const { return sphere_cube_overlap(offset, radius); }
  template <class T>
  PackOf<T> fraction(const Vec3<PackOf<T>>& offset, const PackOf<T>& radius) const {
    return PackOf<T>([&](auto k) {
      return T(sphere_cube_overlap({double(offset.x[k]), double(offset.y[k]), double(offset.z[k])}, double(radius[k])));
    });
  }

  static double touch_radius(double radius) { return radius; }
  static double full_radius(double radius) { return radius; }
};

}  // namespace stresslet
