#pragma once
/// Which cells of which rows a sphere covers, found row by row from the equation of the sphere.
///
/// Lengths in cells; cell i is centred on coordinate i and reaches from i - 1/2 to i + 1/2. With the sphere at c and
/// d = |y - c_y|, e = |z - c_z| for the row (y, z), cell x
///   is touched  where a point of it lies within the touch radius R:
///                 (|x - c_x| - 1/2)_+^2 < R^2 - (d - 1/2)_+^2 - (e - 1/2)_+^2,
///   is full     where all of it lies within the full radius r:
///                 (|x - c_x| + 1/2)^2 <= r^2 - (d + 1/2)^2 - (e + 1/2)^2.
/// Solid-fraction laws name both radii. They are exact for `exact`; the other laws leave a few touched cells at
/// fraction 0, and give fraction 1 to a few that are not counted as full. Periodic images and walls are the caller's:
/// rows and cells come without wrap.
#include <algorithm>
#include <cmath>

#include "stresslet/base/vec3.hpp"

namespace stresslet {

/// Cells begin ... end - 1.
struct CellRange {
  int begin, end;
  int size() const { return end - begin; }
};

/// One row of a sphere: cells that may be partly solid are [touched.begin, full.begin) and [full.end, touched.end);
/// without a full cell, `full` is empty and lies at touched.end.
struct RowSpan {
  int y, z;
  CellRange touched, full;
};

namespace detail {

/// Squared distance, along one axis, from the coordinate `centre` to the nearest and the farthest point of cell `i`.
inline double nearest_squared(int i, double centre) {
  const double d = std::max(std::abs(i - centre) - 0.5, 0.0);
  return d * d;
}
inline double farthest_squared(int i, double centre) {
  const double d = std::abs(i - centre) + 0.5;
  return d * d;
}

/// Integers strictly within `reach` of `centre`.
inline CellRange integers_within(double centre, double reach) {
  return {int(std::floor(centre - reach)) + 1, int(std::ceil(centre + reach))};
}

}  // namespace detail

/// Calls `visit(RowSpan)` for every row with a touched cell, y fastest.
template <class Visit>
void for_each_row_of_sphere(const Vec3<double>& centre, double touch_radius, double full_radius, Visit&& visit) {
  const double touch = touch_radius * touch_radius, fill = full_radius * full_radius;
  const CellRange planes = detail::integers_within(centre.z, touch_radius + 0.5);
  for (int z = planes.begin; z < planes.end; ++z) {
    const double touch_z = touch - detail::nearest_squared(z, centre.z);
    const double fill_z = fill - detail::farthest_squared(z, centre.z);
    if (touch_z <= 0) continue;
    const CellRange rows = detail::integers_within(centre.y, std::sqrt(touch_z) + 0.5);
    for (int y = rows.begin; y < rows.end; ++y) {
      const double touch_x = touch_z - detail::nearest_squared(y, centre.y);
      if (touch_x <= 0) continue;
      RowSpan row{y, z, detail::integers_within(centre.x, std::sqrt(touch_x) + 0.5), {0, 0}};
      if (row.touched.size() <= 0) continue;
      row.full = {row.touched.end, row.touched.end};
      const double fill_x = fill_z - detail::farthest_squared(y, centre.y);
      if (fill_x >= 0.25) {
        const double reach = std::sqrt(fill_x) - 0.5;
        const CellRange full{int(std::ceil(centre.x - reach)), int(std::floor(centre.x + reach)) + 1};
        if (full.size() > 0) row.full = full;
      }
      visit(row);
    }
  }
}

}  // namespace stresslet
