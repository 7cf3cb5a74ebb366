#pragma once
/// Lubrication between a sphere and a flat wall, singular parts; e from the sphere to the wall, epsilon = gap/a,
/// L = ln(1/epsilon), u = wall velocity minus sphere velocity, w = angular velocity of the sphere, per unit viscosity:
///   X = 6 pi a (1/epsilon + L/5)       Cox & Brenner, Chem. Engng Sci. 22 (1967) 1753
///   Y = 16 pi/5 a L                    Goldman, Cox & Brenner, Chem. Engng Sci. 22 (1967) 637: 6 pi a * 8/15 L
///   B = 4 pi/5 a^2 L                   same: 8 pi a^2 * 1/10 L
///   C = 16 pi/5 a^3 L                  same: 8 pi a^3 * 2/5 L
///   F = X u_n e + Y u_t - B w x e,  T = B e x u_t - C w_t
/// (the wall of the sphere-sphere functions as a2 -> infinity, with the logarithm of the sphere's own gap).
#include "stresslet/lubrication/pair_law.hpp"

namespace stresslet {

template <class R>
PairResistance<R> wall_resistance(const R& a, const R& gap) {
  const R epsilon = gap / a;
  const R log = -natural_log(epsilon);
  return {R(6 * pi) * a * (R(1) / epsilon + R(0.2) * log), R(16 * pi / 5) * a * log, R(4 * pi / 5) * a * a * log,
          R(16 * pi / 5) * a * a * a * log};
}

template <class R>
struct WallWrench {
  Vec3<R> force, torque;
};

/// Force and torque on the sphere per unit viscosity; the wall receives minus the force.
template <class R>
WallWrench<R> wall_wrench(const Vec3<R>& e, const PairResistance<R>& k, const Vec3<R>& u, const Vec3<R>& w) {
  const R un = dot(u, e);
  const Vec3<R> ut = u - un * e;
  return {k.X * un * e + k.Y * ut - k.B * cross(w, e), k.B * cross(e, ut) - k.C * tangential_part(w, e)};
}

}  // namespace stresslet
