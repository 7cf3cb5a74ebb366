#pragma once
/// The default. Steady Stokes flow with partially saturated cells depends on the relaxation time tau only through the
/// magic parameter and alpha/lambda, lambda = tau - 1/2 (three times the viscosity). With
///   alpha = lambda epsilon / (1 - epsilon + delta),   B = alpha / (1 + alpha/2)
/// and a fixed magic parameter (TRT or MRT, 1/12) it does not depend on tau. B comes close to 2, so the operator must
/// allow that (superposition, guo-form) and the particle update must be semi-implicit.
///
/// Why this form: a row of cells beside a wall feels it where it is, wherever it cuts the cells, if a cell at the
/// distance d < 1 from it has alpha = (lambda/3) (1/d - 1) (the flux of momentum to a wall at d, not 1). That is
/// epsilon/(1 - epsilon) with solid fractions of a wall half a cell nearer. For spheres three times as much and a
/// radius larger by 0.175 + 0.21/r cells is the best found: how strongly a sphere is felt then hardly depends on where
/// it lies on the grid. The factor, both lengths and delta are fits to drag, torque and stresslet of single spheres of
/// 6 to 20 cells across (theory: partially saturated cells).
#include <string_view>

#include "stresslet/coupling/weights/solid_drag.hpp"

namespace stresslet {

class ViscosityScaledWeight {
 public:
  static constexpr std::string_view name = "viscosity-scaled";
  static constexpr std::string_view summary = "drag in proportion to the viscosity: results independent of tau";
  static constexpr double largest = 2;

  explicit ViscosityScaledWeight(double relaxation_time) : lambda_(relaxation_time - 0.5) {}

  template <class R>
  R drag(const R& solid_fraction) const {
    return as<R>(lambda_) * solid_fraction / (as<R>(1 + delta) - solid_fraction);
  }
  template <class R>
  R weight(const R& solid_fraction) const {
    return weight_from_drag(drag(solid_fraction));
  }
  static double drawn_radius(double radius) { return radius + 0.175 + 0.21 / radius; }

 private:
  static constexpr double delta = 0.03;
  double lambda_;
};

}  // namespace stresslet
