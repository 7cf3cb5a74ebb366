#pragma once
/// Generalised velocities (u, w) and forces (F, T) of all particles, one cache line of eight doubles each:
/// [x y z 0 | x y z 0]. The layout of vectors inside solvers: a pair's two particles cost two cache lines, and sums
/// and scalings run over one contiguous array.
#include <cstdint>

#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/particles/state.hpp"

namespace stresslet {

inline constexpr std::size_t twist_stride = 8;

template <class R>
struct Twist {
  Vec3<R> linear, angular;
};

class TwistVector {
 public:
  void resize(std::size_t particles) { data_.assign(particles * twist_stride, 0.0); }
  std::size_t size() const { return data_.size() / twist_stride; }
  AlignedVector<double>& array() { return data_; }
  double* data() { return data_.data(); }
  const double* data() const { return data_.data(); }
  double* operator[](std::size_t i) { return &data_[i * twist_stride]; }
  const double* operator[](std::size_t i) const { return &data_[i * twist_stride]; }

  Twist<double> get(std::size_t i) const {
    const double* t = (*this)[i];
    return {{t[0], t[1], t[2]}, {t[4], t[5], t[6]}};
  }
  void set(std::size_t i, const Vec3<double>& linear, const Vec3<double>& angular) {
    double* t = (*this)[i];
    t[0] = linear.x, t[1] = linear.y, t[2] = linear.z, t[3] = 0;
    t[4] = angular.x, t[5] = angular.y, t[6] = angular.z, t[7] = 0;
  }
  void set(std::size_t i, const Twist<double>& t) { set(i, t.linear, t.angular); }

  /// Twists of the particles index[0 ... pack_width).
  Twist<Pack> gather(const std::int32_t* index) const {
    const double* t = data_.data();
    return {{stresslet::gather(t, index, twist_stride), stresslet::gather(t + 1, index, twist_stride),
             stresslet::gather(t + 2, index, twist_stride)},
            {stresslet::gather(t + 4, index, twist_stride), stresslet::gather(t + 5, index, twist_stride),
             stresslet::gather(t + 6, index, twist_stride)}};
  }

 private:
  AlignedVector<double> data_;
};

}  // namespace stresslet
