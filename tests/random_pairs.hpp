#pragma once
/// Random pairs, motions and rotations for conformance tests.
#include <array>
#include <cmath>
#include <random>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/vec3.hpp"

namespace stresslet::testing {

class Draw {
 public:
  explicit Draw(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
  Vec3<double> vector() { return {normal_(random_), normal_(random_), normal_(random_)}; }
  Vec3<double> direction() {
    const Vec3<double> v = vector();
    return v / norm(v);
  }
  /// Traceless symmetric tensor.
  SymTensor3<double> strain_rate() {
    const Vec3<double> d = vector(), o = vector();
    const double mean = (d.x + d.y + d.z) / 3;
    return {d.x - mean, d.y - mean, d.z - mean, o.x, o.y, o.z};
  }

 private:
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

/// Rotation matrix applied to a vector: turn by |axis| about axis (Rodrigues).
inline Vec3<double> rotate(const Vec3<double>& axis, const Vec3<double>& v) {
  const double angle = norm(axis);
  const Vec3<double> n = axis / angle;
  return std::cos(angle) * v + std::sin(angle) * cross(n, v) + ((1 - std::cos(angle)) * dot(n, v)) * n;
}

}  // namespace stresslet::testing
