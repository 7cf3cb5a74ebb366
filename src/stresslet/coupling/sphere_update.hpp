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
  const SymTensor3<double> arm =
      (trace(s.second) + moment_of_inertia) * identity3<double>() - s.second;  // of the whole left side
  const auto& m = s.momentum_arm;
  const Vec3<double> push = mass * before.velocity + s.momentum + force;
  const Vec3<double> spin = moment_of_inertia * before.angular_velocity + torque +
                            Vec3<double>{m[2].y - m[1].z, m[0].z - m[2].x, m[1].x - m[0].y};
  if (held) return {before.velocity, inverse(arm) * (spin - cross(s.first, before.velocity))};

  const double whole = mass + s.mass;
  const Vec3<double>& f = s.first;
  Eigen::Matrix<double, 6, 6> matrix;
  matrix << whole, 0, 0, 0, f.z, -f.y,       //
      0, whole, 0, -f.z, 0, f.x,             //
      0, 0, whole, f.y, -f.x, 0,             //
      0, -f.z, f.y, arm.xx, arm.xy, arm.xz,  //
      f.z, 0, -f.x, arm.xy, arm.yy, arm.yz,  //
      -f.y, f.x, 0, arm.xz, arm.yz, arm.zz;
  Eigen::Matrix<double, 6, 1> right;
  right << push.x, push.y, push.z, spin.x, spin.y, spin.z;
  const Eigen::Matrix<double, 6, 1> v = matrix.ldlt().solve(right);
  return {{v(0), v(1), v(2)}, {v(3), v(4), v(5)}};
}

}  // namespace stresslet
