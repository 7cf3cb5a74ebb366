#pragma once
/// Hertzian spring: F = k sqrt(overlap r) overlap, r = a1 a2/(a1 + a2), k a pressure; k = 4/3 E* for elastic spheres.
/// Tangential stiffness: ratio k sqrt(overlap r). Dashpot after Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239:
/// sqrt(5) beta sqrt(m k sqrt r) overlap^(1/4), which gives the restitution e at every speed.
#include <cmath>
#include <string_view>

namespace stresslet {

struct Hertz {
  static constexpr std::string_view name = "hertz";
  static constexpr std::string_view summary = "F = kn sqrt(overlap r) overlap; stiffness is a pressure, kn/(eta gdot)";
  /// The force of the default linear spring at an overlap of 0.0025 of equal spheres: 2.5e5 / sqrt(0.0025 / 4).
  static constexpr double default_stiffness = 1e7;

  template <class R>
  static R force(const R& overlap, const R& reduced_radius, const R& stiffness) {
    return tangential_scale(overlap, reduced_radius, stiffness) * overlap;
  }
  template <class R>
  static R energy(const R& overlap, const R& reduced_radius, const R& stiffness) {
    return R(0.4) * force(overlap, reduced_radius, stiffness) * overlap;
  }
  template <class R>
  static R tangential_scale(const R& overlap, const R& reduced_radius, const R& stiffness) {
    using std::sqrt;
    return stiffness * sqrt(overlap * reduced_radius);
  }
  template <class R>
  static R tangent_stiffness(const R& overlap, const R& reduced_radius, const R& stiffness) {
    return R(1.5) * tangential_scale(overlap, reduced_radius, stiffness);
  }
  template <class R>
  static R dashpot(const R& overlap, const R& reduced_radius, const R& stiffness, const R& reduced_mass,
                   const R& damping_ratio) {
    using std::sqrt;
    return R(std::sqrt(5.0)) * damping_ratio * sqrt(reduced_mass * stiffness * sqrt(reduced_radius * overlap));
  }
};

}  // namespace stresslet
