#pragma once
/// Full neighbour lists for the packing steps, with a skin: valid until some sphere has moved half of it.
#include <cstdint>
#include <span>
#include <vector>

#include "stresslet/particles/cell_grid.hpp"
#include "stresslet/particles/packing/spheres.hpp"

namespace stresslet {

class NearList {
 public:
  explicit NearList(double skin) : skin_(skin) {}

  /// Lists, for each sphere, all others with surfaces nearer than the skin at this inflation.
  void build(const Spheres& spheres, double inflation);

  /// Builds anew if a sphere has moved or grown too far since the last build.
  void update(const Spheres& spheres, double inflation);

  /// Has sphere i moved so far that lists must be built anew?
  bool moved_too_far(const Spheres& spheres, std::size_t i) const;

  std::span<const std::int32_t> of(std::size_t i) const {
    return std::span(neighbour_).subspan(start_[i], start_[i + 1] - start_[i]);
  }

 private:
  double skin_;
  double inflation_ = 0;
  CellGrid grid_;
  std::vector<double> x_, y_, z_;  ///< positions at the last build
  std::vector<std::int32_t> smaller_, larger_;
  std::vector<std::size_t> start_;
  std::vector<std::int32_t> neighbour_;
};

}  // namespace stresslet
