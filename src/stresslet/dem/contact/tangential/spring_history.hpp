#pragma once
/// Tangential spring with history and Coulomb limit (Cundall & Strack 1979; Luding, Granular Matter 10 (2008) 235).
///
///   zeta <- (zeta turned into the present tangent plane, length kept) + v_s dt
///   F_t = kt zeta on sphere 1;  |F_t| > limit: zeta and F_t are scaled back to the limit (sliding)
/// v_s: velocity of sphere 2's surface relative to sphere 1's at the contact,
///   v_s = u_t - (l1 w1 + l2 w2) x e,  l_i = a_i R/(a1 + a2), so l1 + l2 = R and torques balance exactly.
/// `slip` is the part of this step's displacement that was lost to sliding, positive along F_t: F_t . slip is the
/// work turned into heat.
#include <cmath>

#include "stresslet/base/vec3.hpp"

namespace stresslet {

struct TangentialSpring {
  Vec3<double> elongation;
  Vec3<double> force;
  Vec3<double> slip;
};

inline TangentialSpring advance_tangential_spring(const Vec3<double>& elongation, const Vec3<double>& normal,
                                                  const Vec3<double>& displacement, double stiffness, double limit) {
  Vec3<double> zeta = tangential_part(elongation, normal);
  const double old_length = norm(elongation), new_length = norm(zeta);
  if (new_length > 0) zeta = (old_length / new_length) * zeta;
  zeta += displacement;
  const double force = stiffness * norm(zeta);
  if (force <= limit) return {zeta, stiffness * zeta, {}};
  const Vec3<double> held = (limit / force) * zeta;
  return {held, stiffness * held, zeta - held};
}

}  // namespace stresslet
