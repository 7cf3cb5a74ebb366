#pragma once
/// Linear spring: F = k overlap, k in units of force per length. Tangential stiffness: ratio k. Dashpot for restitution
/// e: 2 beta sqrt(m k), beta = -ln e / sqrt(pi^2 + ln^2 e), exact when the contact lasts until the overlap is zero.
/// Cundall & Strack, Geotechnique 29 (1979) 47; Schwager & Poeschel, Granular Matter 9 (2007) 465.
#include <cmath>
#include <string_view>

namespace stresslet {

struct Hooke {
  static constexpr std::string_view name = "hooke";
  static constexpr std::string_view summary = "linear spring; stiffness is a force per length, kn* = kn/(eta gdot d1)";
  static constexpr double default_stiffness = 2.5e5;

  template <class R>
  static R force(const R& overlap, const R&, const R& stiffness) {
    return stiffness * overlap;
  }
  template <class R>
  static R energy(const R& overlap, const R&, const R& stiffness) {
    return R(0.5) * stiffness * overlap * overlap;
  }
  /// Stiffness of the tangential spring per unit tangential ratio.
  template <class R>
  static R tangential_scale(const R&, const R&, const R& stiffness) {
    return stiffness;
  }
  /// dF/d overlap.
  template <class R>
  static R tangent_stiffness(const R&, const R&, const R& stiffness) {
    return stiffness;
  }
  template <class R>
  static R dashpot(const R&, const R&, const R& stiffness, const R& reduced_mass, const R& damping_ratio) {
    using std::sqrt;
    return R(2) * damping_ratio * sqrt(reduced_mass * stiffness);
  }
};

}  // namespace stresslet
