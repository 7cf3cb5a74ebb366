#pragma once
/// Resistance between two spheres, whatever its origin, for the solve of all spheres together.
#include <Eigen/Dense>
#include <cstdint>

#include "stresslet/base/vec3.hpp"
#include "stresslet/lubrication/fluid_coupling.hpp"

namespace stresslet {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

inline Vector6 stacked(const Vec3<double>& a, const Vec3<double>& b) {
  Vector6 v;
  v << a.x, a.y, a.z, b.x, b.y, b.z;
  return v;
}

/// Forces and torques on both spheres are  -resistance (U1, w1, U2 + jump, w2),  in lattice units, each about its own
/// centre. `resistance` is symmetric and positive semi-definite and feels no rigid motion of the pair.
struct SphereLink {
  std::int32_t first, second;
  Matrix12 resistance;
  Vec3<double> jump;  ///< velocity of the image of `second` that meets `first`, less that of `second`
};

/// [a] with [a] b = a x b.
inline Eigen::Matrix3d cross_matrix(const Vec3<double>& a) {
  Eigen::Matrix3d m;
  m << 0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0;
  return m;
}

inline SphereLink link_of(const PointFriction& f) {
  Eigen::Matrix<double, 3, 12> relative;  // u1 - u2
  relative << Eigen::Matrix3d::Identity(), -cross_matrix(f.arm_first), -Eigen::Matrix3d::Identity(),
      cross_matrix(f.arm_second);
  return {f.first, f.second, f.coefficient * relative.transpose() * relative, f.jump};
}

}  // namespace stresslet
