#pragma once
/// The gradient of a velocity field at a cell from the velocities of cells and walls around it.
///
/// Along each axis the derivative is that of the parabola through the cell and two more points at a and b (in cells,
/// signed, different from each other and from 0):
///   f'(0) = -(a + b)/(a b) f(0) - b/(a (a - b)) f(a) - a/(b (b - a)) f(b).
/// Second order in the cell size; between two neighbours (a = -1, b = 1) the central difference, and exact for
/// parabolas beside a half-way wall (a = -1/2).
///
/// Dissipation per volume of an incompressible Newtonian fluid: 2 mu S:S, S the symmetric part of the gradient. For a
/// shear rate gdot imposed on a box, viscosity = dissipation / gdot^2 (docs/theory.md).
#include "stresslet/base/vec3.hpp"

namespace stresslet {

/// A velocity known at a place on the axis through the cell; offset 0 where none is known.
struct VelocityAt {
  double offset = 0;
  Vec3<double> velocity{};
};

inline Vec3<double> derivative(const Vec3<double>& here, const VelocityAt& first, const VelocityAt& second) {
  const double a = first.offset, b = second.offset;
  return (-(a + b) / (a * b)) * here + (-b / (a * (a - b))) * first.velocity + (-a / (b * (b - a))) * second.velocity;
}

/// Strain rate from the derivatives of the velocity along x, y and z.
inline SymTensor3<double> strain_rate_of(const Vec3<double>& along_x, const Vec3<double>& along_y,
                                         const Vec3<double>& along_z) {
  return {along_x.x,
          along_y.y,
          along_z.z,
          0.5 * (along_y.x + along_x.y),
          0.5 * (along_z.x + along_x.z),
          0.5 * (along_z.y + along_y.z)};
}

/// S:S.
inline double square_sum(const SymTensor3<double>& s) {
  return s.xx * s.xx + s.yy * s.yy + s.zz * s.zz + 2 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz);
}

}  // namespace stresslet
