#pragma once
/// B = epsilon, the solid fraction itself: Noble & Torczynski, Int. J. Mod. Phys. C 9 (1998) 1189, simplified by later
/// authors. Thesis preset. Results depend on the relaxation time.
///
/// Pattern of a solid weight: made once from the relaxation time, gives `weight` B and `drag` alpha (solid_drag.hpp) of
/// a solid fraction in [0, 1]. `drawn_radius` is that of the sphere which the solid fractions are made of, so that the
/// flow feels one of the radius given (lengths in cells). Use viscosity-scaled if unsure.
///   law                 B(1)                  depends on the viscosity   operators
///   linear              1                     no                         any
///   noble-torczynski    1                     yes                        any
///   viscosity-scaled    2 less a little       so that results do not     those that allow B up to 2
#include <string_view>

#include "stresslet/coupling/weights/solid_drag.hpp"

namespace stresslet {

class LinearWeight {
 public:
  static constexpr std::string_view name = "linear";
  static constexpr std::string_view summary = "the solid fraction itself";
  static constexpr double largest = 1;  ///< upper bound of B

  explicit LinearWeight(double /*relaxation_time*/) {}

  template <class R>
  R weight(const R& solid_fraction) const {
    return solid_fraction;
  }
  template <class R>
  R drag(const R& solid_fraction) const {
    return drag_from_weight(weight(solid_fraction));
  }
  static double drawn_radius(double radius) { return radius; }
};

}  // namespace stresslet
