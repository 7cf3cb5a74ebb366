#pragma once
#include <cmath>
/// Three-component vector and symmetric 3x3 tensor over any value type (float, double, SIMD pack).
/// Axes throughout the project: x = flow, y = velocity gradient, z = vorticity.

namespace stresslet {

template <class R>
struct Vec3 {
  R x{}, y{}, z{};

  Vec3& operator+=(const Vec3& b) { return *this = *this + b; }
  Vec3& operator-=(const Vec3& b) { return *this = *this - b; }
  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
  friend Vec3 operator*(const R& s, const Vec3& a) { return {s * a.x, s * a.y, s * a.z}; }
  friend Vec3 operator*(const Vec3& a, const R& s) { return s * a; }
  friend Vec3 operator/(const Vec3& a, const R& s) { return (R(1) / s) * a; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class R>
R dot(const Vec3<R>& a, const Vec3<R>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class R>
Vec3<R> cross(const Vec3<R>& a, const Vec3<R>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class R>
R norm(const Vec3<R>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

/// Part of `a` perpendicular to the unit vector `e`.
template <class R>
Vec3<R> tangential_part(const Vec3<R>& a, const Vec3<R>& e) {
  return a - dot(a, e) * e;
}

/// Symmetric 3x3 tensor: six components, in the order in which they are written to files.
template <class R>
struct SymTensor3 {
  R xx{}, yy{}, zz{}, xy{}, xz{}, yz{};

  SymTensor3& operator+=(const SymTensor3& b) { return *this = *this + b; }
  SymTensor3& operator-=(const SymTensor3& b) { return *this = *this - b; }
  friend SymTensor3 operator+(const SymTensor3& a, const SymTensor3& b) {
    return {a.xx + b.xx, a.yy + b.yy, a.zz + b.zz, a.xy + b.xy, a.xz + b.xz, a.yz + b.yz};
  }
  friend SymTensor3 operator-(const SymTensor3& a, const SymTensor3& b) {
    return {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy, a.xz - b.xz, a.yz - b.yz};
  }
  friend SymTensor3 operator*(const R& s, const SymTensor3& a) {
    return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.xz, s * a.yz};
  }
  friend bool operator==(const SymTensor3&, const SymTensor3&) = default;
};

/// (a b + b a) / 2.
template <class R>
SymTensor3<R> symmetric_product(const Vec3<R>& a, const Vec3<R>& b) {
  const R half(0.5);
  return {a.x * b.x,
          a.y * b.y,
          a.z * b.z,
          half * (a.x * b.y + a.y * b.x),
          half * (a.x * b.z + a.z * b.x),
          half * (a.y * b.z + a.z * b.y)};
}

template <class R>
R trace(const SymTensor3<R>& a) {
  return a.xx + a.yy + a.zz;
}

template <class R>
Vec3<R> operator*(const SymTensor3<R>& a, const Vec3<R>& b) {
  return {a.xx * b.x + a.xy * b.y + a.xz * b.z, a.xy * b.x + a.yy * b.y + a.yz * b.z,
          a.xz * b.x + a.yz * b.y + a.zz * b.z};
}

/// a : b.
template <class R>
R double_contraction(const SymTensor3<R>& a, const SymTensor3<R>& b) {
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + R(2) * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

/// e e for a unit (or any) vector e.
template <class R>
SymTensor3<R> square(const Vec3<R>& e) {
  return {e.x * e.x, e.y * e.y, e.z * e.z, e.x * e.y, e.x * e.z, e.y * e.z};
}

template <class R>
SymTensor3<R> identity3() {
  return {R(1), R(1), R(1), R(0), R(0), R(0)};
}

/// Inverse of a regular tensor.
template <class R>
inline SymTensor3<R> inverse(const SymTensor3<R>& a) {
  const SymTensor3<R> adjugate{a.yy * a.zz - a.yz * a.yz, a.xx * a.zz - a.xz * a.xz, a.xx * a.yy - a.xy * a.xy,
                               a.xz * a.yz - a.xy * a.zz, a.xy * a.yz - a.xz * a.yy, a.xy * a.xz - a.xx * a.yz};
  const R determinant = a.xx * adjugate.xx + a.xy * adjugate.xy + a.xz * adjugate.xz;
  return (R(1) / determinant) * adjugate;
}

}  // namespace stresslet
