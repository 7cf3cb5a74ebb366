#pragma once
/// Cell grid over the box, for neighbour searches whose range differs from particle to particle.
///
/// A query at `position` with range `reach` names every particle whose nearest image lies within `reach`, and some
/// more (a superset, each particle once, itself included), whatever the box: rows reached by crossing y are searched
/// at x - n offset, in the frame of the image they belong to; boxes of fewer cells than a query needs are searched
/// whole. Cells are stored with x fastest, so that a row of cells is one or two runs of contiguous particles.
///
/// Half lists: with radii of similar size take `reach` = a_i + a_max + ..., and keep j > i. With widely different
/// radii take `reach` = 2 a_i + ..., and keep a_j < a_i, or a_j == a_i and j > i: small particles then search near.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/particles/box.hpp"

namespace stresslet {

class CellGrid {
 public:
  /// Sorts the particles into cells no narrower than `cell_size` (wider where cells would outnumber particles by
  /// far). Positions lie in the box. Storage is kept between builds. Order within a cell is that of the indices.
  void build(const Box& box, std::span<const double> x, std::span<const double> y, std::span<const double> z,
             double cell_size);

  /// Calls `visit(std::span<const std::int32_t>)` for runs of particles, in an order that depends on the arguments
  /// alone. Allocates nothing; any number of threads may query.
  template <class Visit>
  void for_each_run(const Vec3<double>& position, double reach, Visit&& visit) const;

  /// The same, particle by particle: `visit(std::int32_t)`.
  template <class Visit>
  void for_each_candidate(const Vec3<double>& position, double reach, Visit&& visit) const {
    for_each_run(position, reach, [&](std::span<const std::int32_t> run) {
      for (const std::int32_t j : run) visit(j);
    });
  }

  /// Particles along the Morton curve through the cells: entry k is the index of the particle that becomes number k.
  std::vector<std::int32_t> spatial_order() const;

  const Box& box() const { return box_; }
  int cells_x() const { return count_.x; }
  int cells_y() const { return count_.y; }
  int cells_z() const { return count_.z; }

 private:
  /// Cells first ... first + count - 1 along one axis, not yet brought into the box.
  struct Interval {
    int first, count;
  };

  static int cell_of(double v, double cells_per_length, int count) {
    const int c = int(v * cells_per_length);
    return c < 0 ? 0 : (c < count ? c : count - 1);
  }

  /// Cells that [v - reach, v + reach] touches on a periodic axis, each at most once.
  static Interval periodic_interval(double v, double reach, double cells_per_length, int count) {
    const double low = std::floor((v - reach) * cells_per_length), high = std::floor((v + reach) * cells_per_length);
    if (high - low + 1 >= count) return {0, count};
    return {int(low), int(high - low) + 1};
  }

  static int floor_divided(int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); }

  std::int32_t start_of(int cx, int cy, int cz) const {
    return start_[std::size_t((cz * count_.y + cy) * count_.x + cx)];
  }

  /// Visits `xs` of one row of cells.
  template <class Visit>
  void visit_row(int cy, int cz, const Interval& xs, Visit&& visit) const {
    const int first = xs.first - count_.x * floor_divided(xs.first, count_.x);
    const int last = first + xs.count;
    const auto run = [&](int from, int to) {
      const std::int32_t begin = start_of(from, cy, cz), end = start_of(to, cy, cz);
      if (begin != end) visit(std::span(particle_).subspan(std::size_t(begin), std::size_t(end - begin)));
    };
    run(first, last < count_.x ? last : count_.x);
    if (last > count_.x) run(0, last - count_.x);
  }

  Box box_;
  Vec3<int> count_{1, 1, 1};
  Vec3<double> cells_per_length_{1, 1, 1};
  std::vector<std::int32_t> start_;     ///< first entry of each cell in `particle_`, x fastest, then y; one more entry
  std::vector<std::int32_t> particle_;  ///< particle indices, cell after cell
  std::vector<std::int32_t> cell_;      ///< cell of each particle
};

template <class Visit>
void CellGrid::for_each_run(const Vec3<double>& p, double reach, Visit&& visit) const {
  const double wide = reach + 1e-12 * (reach + box_.length.x + box_.length.y + box_.length.z);
  const auto [per_x, per_y, per_z] = cells_per_length_;
  const Interval zs = periodic_interval(p.z, wide, per_z, count_.z);
  const int low = int(std::floor(std::max((p.y - wide) * per_y, -2.0 * count_.y)));
  const int high = int(std::floor(std::min((p.y + wide) * per_y, 3.0 * count_.y)));

  const auto visit_rows = [&](int cy, const Interval& xs) {
    for (int k = 0; k < zs.count; ++k) {
      const int cz = zs.first + k;
      visit_row(cy, cz - count_.z * floor_divided(cz, count_.z), xs, visit);
    }
  };

  if (!box_.periodic_in_y()) {
    const Interval xs = periodic_interval(p.x, wide, per_x, count_.x);
    const int last = std::clamp(high, 0, count_.y - 1);
    for (int cy = std::clamp(low, 0, count_.y - 1); cy <= last; ++cy) visit_rows(cy, xs);
  } else if (high - low + 1 > count_.y) {
    // Some row is within reach through two images, which may be shifted against each other: take rows whole.
    for (int cy = 0; cy < count_.y; ++cy) visit_rows(cy, {0, count_.x});
  } else {
    for (int row = low; row <= high; ++row) {
      const int images_up = floor_divided(row, count_.y);
      visit_rows(row - count_.y * images_up, periodic_interval(p.x - images_up * box_.offset, wide, per_x, count_.x));
    }
  }
}

}  // namespace stresslet
