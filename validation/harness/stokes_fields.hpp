#pragma once
/// Exact Stokes flows, as starts close to the steady state and as references.
#include <cmath>

#include "stresslet/base/vec3.hpp"

namespace stresslet::validation {

/// Flow about a sphere of this radius at the origin in the shear u = (rate y, 0, 0), without force on the sphere, which
/// turns with `spin` about z; inside it, the sphere's velocity. With E the rate of strain,
///   u = E x + Omega x x - (a/r)^5 E x - (5/2) (a^3/r^5) (1 - a^2/r^2) x (x E x) + (a/r)^3 (spin - Omega) x x
/// (Kim & Karrila, Microhydrodynamics (1991), section 2.4). Free: spin = -rate/2.
inline Vec3<double> sphere_in_shear(const Vec3<double>& x, double radius, double rate, double spin) {
  const double r2 = dot(x, x), a2 = radius * radius;
  if (r2 <= a2) return {-spin * x.y, spin * x.x, 0};
  const double q3 = std::pow(a2 / r2, 1.5), q5 = q3 * a2 / r2;
  const Vec3<double> strain{0.5 * rate * x.y, 0.5 * rate * x.x, 0};
  const double turning = q3 * (spin + 0.5 * rate);
  return Vec3<double>{rate * x.y, 0, 0} - q5 * strain - (2.5 * q3 / r2 * (1 - a2 / r2) * rate * x.x * x.y) * x +
         turning * Vec3<double>{-x.y, x.x, 0};
}

/// Flow about a sphere at the origin that moves with `velocity` through fluid at rest.
inline Vec3<double> moving_sphere(const Vec3<double>& x, double radius, const Vec3<double>& velocity) {
  const double r2 = dot(x, x), q2 = radius * radius / r2, q = std::sqrt(q2);
  if (r2 <= radius * radius) return velocity;
  return (0.25 * q * (3 + q2)) * velocity + (0.75 * q * (1 - q2) * dot(velocity, x) / r2) * x;
}

/// Symmetric velocity gradient by central differences.
template <class Field>
SymTensor3<double> strain_rate_of(Field&& field, const Vec3<double>& x) {
  constexpr double h = 1e-3;
  const auto slope = [&](const Vec3<double>& step) { return (0.5 / h) * (field(x + step) - field(x - step)); };
  const Vec3<double> dx = slope({h, 0, 0}), dy = slope({0, h, 0}), dz = slope({0, 0, h});
  return {dx.x, dy.y, dz.z, 0.5 * (dx.y + dy.x), 0.5 * (dx.z + dz.x), 0.5 * (dy.z + dz.y)};
}

}  // namespace stresslet::validation
