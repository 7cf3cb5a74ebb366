#pragma once
/// New velocities of one sphere from the momentum that it exchanges with the fluid in this very step, semi-implicit:
///   (M + m) U + w x s1                       = M U0 + sum m u*       + force
///   s1 x U + (I + sum m (r.r - r r)) w       = I w0 + sum r x m u*   + torque,       s1 = sum m r,
/// with the sums of exchange_sums.hpp. Symmetric and positive definite, stable for any weight B < 2 and any density; an
/// explicit update is not beyond B = 2/(1 + fluid density/sphere density).
#include <Eigen/Dense>

#include "stresslet/coupling/exchange_sums.hpp"

namespace stresslet {

struct SphereVelocities {
  Vec3<double> velocity{}, angular_velocity{};
};

/// `mass` and `moment_of_inertia` in lattice units; `force`, `torque` are those of everything but the fluid, a step
/// long. `held` keeps the velocity at that of `before` and lets the sphere rotate.
inline SphereVelocities settled_velocities(const ExchangeSums<double>& s, double mass, double moment_of_inertia,
                                           const SphereVelocities& before, const Vec3<double>& force,
                                           const Vec3<double>& torque, bool held = false) {
  const SymTensor3<double> arm = trace(s.second) * identity3<double>() - s.second;
  Eigen::Matrix3d second;
  second << arm.xx, arm.xy, arm.xz, arm.xy, arm.yy, arm.yz, arm.xz, arm.yz, arm.zz;
  second.diagonal().array() += moment_of_inertia;
  const auto eigen = [](const Vec3<double>& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  const auto own = [](const auto& v) { return Vec3<double>{v(0), v(1), v(2)}; };
  const auto& m = s.momentum_arm;
  const Vec3<double> spin = moment_of_inertia * before.angular_velocity + torque +
                            Vec3<double>{m[2].y - m[1].z, m[0].z - m[2].x, m[1].x - m[0].y};
  if (held)
    return {before.velocity, own(Eigen::Vector3d(second.ldlt().solve(eigen(spin - cross(s.first, before.velocity)))))};

  Eigen::Matrix3d cross_first;
  cross_first << 0, -s.first.z, s.first.y, s.first.z, 0, -s.first.x, -s.first.y, s.first.x, 0;
  Eigen::Matrix<double, 6, 6> matrix;
  matrix << (mass + s.mass) * Eigen::Matrix3d::Identity(), -cross_first, cross_first, second;
  Eigen::Matrix<double, 6, 1> right;
  right << eigen(mass * before.velocity + s.momentum + force), eigen(spin);
  const Eigen::Matrix<double, 6, 1> solved = matrix.ldlt().solve(right);
  return {own(solved.head<3>()), own(solved.tail<3>())};
}

}  // namespace stresslet
