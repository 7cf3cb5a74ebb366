#pragma once
/// Solid fraction linear in the distance of the cell centre from the surface: Jones & Williams, Eng. Comput. 34 (2017)
/// 1204:  fraction = f - D within [0, 1],  D = |x| - r,  f = 1/2 + (mean height of the sphere over the unit square
/// about its axis) - r = 1/2 - 1/(12 r) + O(r^-3), of which the first two terms are used: the correction of
/// curvature.hpp.
///
/// Cheapest law. It knows nothing of the direction of the surface: errors of a single cell up to 0.048 + 0.06/r, the
/// first for planes across the space diagonal. The fractions of a sphere add up to its volume within 0.25/r^2 at any
/// position, on average as those of plane-cut.
#include <cmath>
#include <string_view>

#include "stresslet/base/vec3.hpp"
#include "stresslet/coupling/solid_fraction/curvature.hpp"
#include "stresslet/exec/simd.hpp"

namespace stresslet {

struct DistanceWeighting {
  static constexpr std::string_view name = "distance-weighting";
  static constexpr std::string_view summary = "linear in the distance from the surface, blind to its direction";

  template <class R>
  R fraction(const Vec3<R>& offset, const R& radius) const {
    using std::max, std::min;
    const R ramp = as<R>(0.5) + curvature_corrected(radius) - norm(offset);
    return max(min(ramp, as<R>(1)), as<R>(0));
  }

  static double touch_radius(double radius) { return curvature_corrected(radius); }
  static double full_radius(double radius) { return curvature_corrected(radius); }
};

}  // namespace stresslet
