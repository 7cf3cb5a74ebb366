#pragma once
/// The default. Steady Stokes flow with partially saturated cells depends on the relaxation time tau only through the
/// magic parameter and alpha/lambda, lambda = tau - 1/2 (three times the viscosity). With
///   alpha = kappa lambda epsilon / ((1 - epsilon)^2 + delta),   B = alpha / (1 + alpha/2)
/// and a fixed magic parameter (TRT or MRT, 1/12) it does not depend on tau. kappa and delta are fits to the drag of
/// cubic arrays of spheres of 10 cells across. B comes close to 2, so the operator must allow that (superposition,
/// guo-form) and the particle update must be semi-implicit.
#include <string_view>

#include "stresslet/coupling/weights/solid_drag.hpp"

namespace stresslet {

class ViscosityScaledWeight {
 public:
  static constexpr std::string_view name = "viscosity-scaled";
  static constexpr std::string_view summary = "drag in proportion to the viscosity: results independent of tau";
  static constexpr double largest = 2;

  explicit ViscosityScaledWeight(double relaxation_time, double kappa = 2.35, double delta = 0.03)
      : scale_(kappa * (relaxation_time - 0.5)), delta_(delta) {}

  template <class R>
  R drag(const R& solid_fraction) const {
    const R fluid_fraction = as<R>(1) - solid_fraction;
    return as<R>(scale_) * solid_fraction / (fluid_fraction * fluid_fraction + as<R>(delta_));
  }
  template <class R>
  R weight(const R& solid_fraction) const {
    return weight_from_drag(drag(solid_fraction));
  }

 private:
  double scale_, delta_;
};

}  // namespace stresslet
