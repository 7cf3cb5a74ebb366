#pragma once
/// Noble & Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189:
///   B = epsilon lambda / ((1 - epsilon) + lambda),   lambda = tau - 1/2.
#include <string_view>

#include "stresslet/coupling/weights/solid_drag.hpp"

namespace stresslet {

class NobleTorczynskiWeight {
 public:
  static constexpr std::string_view name = "noble-torczynski";
  static constexpr std::string_view summary = "solid fraction, lessened where the viscosity is small";
  static constexpr double largest = 1;

  explicit NobleTorczynskiWeight(double relaxation_time) : lambda_(relaxation_time - 0.5) {}

  template <class R>
  R weight(const R& solid_fraction) const {
    return as<R>(lambda_) * solid_fraction / ((as<R>(1) - solid_fraction) + as<R>(lambda_));
  }
  template <class R>
  R drag(const R& solid_fraction) const {
    return drag_from_weight(weight(solid_fraction));
  }
  static double drawn_radius(double radius) { return radius; }

 private:
  double lambda_;
};

}  // namespace stresslet
