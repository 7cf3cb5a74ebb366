#pragma once
/// Stokes flows about spheres, as starts close to the steady state and as references.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/vec3.hpp"

namespace stresslet::validation {

/// What a sphere gives to the fluid: force, torque, stresslet.
struct Strength {
  Vec3<double> force{}, torque{};
  SymTensor3<double> stresslet{};
};

/// Velocity at x from the centre of a sphere of radius a, outside it, with strength (F, T, S):
///   force      F/(6 pi eta a) along with the flow about a moving sphere
///   torque     T x x / (8 pi eta r^3)
///   stresslet  -(a/r)^5 E x - (5/2) (a^3/r^5) (1 - a^2/r^2) x (x E x),   E = S / (20/3 pi eta a^3)
/// exact for a single sphere (Kim & Karrila, Microhydrodynamics (1991), section 2.4 and chapter 4).
inline Vec3<double> disturbance(const Vec3<double>& x, double a, double viscosity, const Strength& s) {
  const double r2 = dot(x, x), q2 = a * a / r2, q = std::sqrt(q2), q3 = q2 * q;
  const Vec3<double> u = (1 / (6 * pi * viscosity * a)) * s.force;
  const SymTensor3<double> strain = (3 / (20 * pi * viscosity * a * a * a)) * s.stresslet;
  const Vec3<double> stretched = strain * x;
  return (0.25 * q * (3 + q2)) * u + (0.75 * q * (1 - q2) * dot(u, x) / r2) * x +
         (1 / (8 * pi * viscosity * r2 * std::sqrt(r2))) * cross(s.torque, x) - (q3 * q2) * stretched -
         (2.5 * q3 * (1 - q2) * dot(stretched, x) / r2) * x;
}

/// Pressure of the same flow: F x/(4 pi r^3) - 5 eta a^3 (x E x)/r^5.
inline double disturbance_pressure(const Vec3<double>& x, const Strength& s) {
  const double r2 = dot(x, x), r3 = r2 * std::sqrt(r2);
  return dot(s.force, x) / (4 * pi * r3) - 0.75 / pi * dot(x, s.stresslet * x) / (r3 * r2);
}

/// What a wall at rest at y = 0 adds to the flow v of pressure p, whose sources lie above it, J the mirror image
/// (Lorentz; Kim & Karrila, section 12.2; no slip and no divergence are quick to check):
///   w(x) = -v(Jx) + 2 y grad [v_y(Jx)] + (y^2/eta) grad [p(Jx)]
template <class Velocity, class Pressure>
Vec3<double> wall_image(Velocity&& v, Pressure&& p, double viscosity, const Vec3<double>& x) {
  constexpr double h = 1e-3;
  const auto mirrored = [](const Vec3<double>& y) { return Vec3<double>{y.x, -y.y, y.z}; };
  const auto gradient = [&](const auto& f) {
    const auto slope = [&](const Vec3<double>& e) { return (f(mirrored(x + e)) - f(mirrored(x - e))) / (2 * h); };
    return Vec3<double>{slope({h, 0, 0}), slope({0, h, 0}), slope({0, 0, h})};
  };
  return -v(mirrored(x)) + (2 * x.y) * gradient([&](const Vec3<double>& y) { return v(y).y; }) +
         (x.y * x.y / viscosity) * gradient(p);
}

/// Flow about a sphere at the origin in the shear u = (rate y, 0, 0), without force on the sphere, which turns with
/// `spin` about z; inside it, the sphere's velocity. Free: spin = -rate/2.
inline Vec3<double> sphere_in_shear(const Vec3<double>& x, double radius, double rate, double spin) {
  const double a3 = radius * radius * radius;
  if (dot(x, x) <= radius * radius) return {-spin * x.y, spin * x.x, 0};
  const Strength given{{}, {0, 0, 8 * pi * a3 * (spin + 0.5 * rate)}, {0, 0, 0, 10 * pi / 3 * a3 * rate, 0, 0}};
  return Vec3<double>{rate * x.y, 0, 0} + disturbance(x, radius, 1, given);
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
