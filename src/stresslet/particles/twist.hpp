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
static_assert(twist_stride % pack_width == 0);

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

  /// Twists of the particles index[0 ... pack_width): whole lines are loaded and transposed in registers.
  Twist<Pack> gather(const std::int32_t* index) const {
    Pack column[twist_stride];
    for (std::size_t c = 0; c < twist_stride; c += pack_width) {
      for (std::size_t k = 0; k < pack_width; ++k) column[c + k] = load((*this)[std::size_t(index[k])] + c);
      transpose(column + c);
    }
    return {{column[0], column[1], column[2]}, {column[4], column[5], column[6]}};
  }

  /// Sets the twists begin ... begin + pack_width - 1.
  void scatter(std::size_t begin, const Vec3<Pack>& linear, const Vec3<Pack>& angular) {
    const Pack zero = 0.0;
    Pack column[twist_stride] = {linear.x, linear.y, linear.z, zero, angular.x, angular.y, angular.z, zero};
    for (std::size_t c = 0; c < twist_stride; c += pack_width) {
      transpose(column + c);
      for (std::size_t k = 0; k < pack_width; ++k) store((*this)[begin + k] + c, column[c + k]);
    }
  }

 private:
  AlignedVector<double> data_;
};

/// Sum of a twist and rows of twist vectors, a line at a time.
class RowSum {
 public:
  explicit RowSum(const Twist<double>& t)
      : sum_{t.linear.x, t.linear.y, t.linear.z, 0, t.angular.x, t.angular.y, t.angular.z, 0} {}
  void add(const double* row) {
    for (std::size_t c = 0; c < twist_stride; ++c) sum_[c] += row[c];
  }
  Twist<double> twist() const { return {{sum_[0], sum_[1], sum_[2]}, {sum_[4], sum_[5], sum_[6]}}; }

 private:
  double sum_[twist_stride];
};

}  // namespace stresslet
