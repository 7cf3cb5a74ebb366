#include "stresslet/particles/cell_grid.hpp"

#include <algorithm>
#include <numeric>

namespace stresslet {

namespace {

constexpr double most_cells_per_particle = 8;
constexpr double most_cells_per_axis = 1024;

/// Spreads the lowest ten bits of v to every third bit.
std::uint32_t spread_bits(std::uint32_t v) {
  v = (v | (v << 16)) & 0x030000FFu;
  v = (v | (v << 8)) & 0x0300F00Fu;
  v = (v | (v << 4)) & 0x030C30C3u;
  return (v | (v << 2)) & 0x09249249u;
}

}  // namespace

void CellGrid::build(const Box& box, std::span<const double> x, std::span<const double> y, std::span<const double> z,
                     double cell_size) {
  box_ = box;
  const std::size_t n = x.size();
  const double width = std::max(cell_size, std::cbrt(box.volume() / (most_cells_per_particle * double(n + 1))));
  const auto cells = [width](double length) {
    return int(std::clamp(std::floor(length / width), 1.0, most_cells_per_axis));
  };
  count_ = {cells(box.length.x), cells(box.length.y), cells(box.length.z)};
  cells_per_length_ = {count_.x / box.length.x, count_.y / box.length.y, count_.z / box.length.z};

  // One slot beyond the last row serves `start_of` at cell count_.x of that row.
  start_.assign(std::size_t(count_.x) * std::size_t(count_.y) * std::size_t(count_.z) + 1, 0);
  cell_.resize(n);
  particle_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const int cx = cell_of(x[i], cells_per_length_.x, count_.x);
    const int cy = cell_of(y[i], cells_per_length_.y, count_.y);
    const int cz = cell_of(z[i], cells_per_length_.z, count_.z);
    cell_[i] = (cz * count_.y + cy) * count_.x + cx;
    ++start_[std::size_t(cell_[i])];
  }
  std::inclusive_scan(start_.begin(), start_.end(), start_.begin());
  for (std::size_t i = n; i-- > 0;) particle_[std::size_t(--start_[std::size_t(cell_[i])])] = std::int32_t(i);
}

std::vector<std::int32_t> CellGrid::spatial_order() const {
  std::vector<std::uint32_t> key(cell_.size());
  for (std::size_t i = 0; i < cell_.size(); ++i) {
    const int c = cell_[i];
    const int cx = c % count_.x, cy = c / count_.x % count_.y, cz = c / (count_.x * count_.y);
    key[i] = spread_bits(std::uint32_t(cx)) | spread_bits(std::uint32_t(cy)) << 1 | spread_bits(std::uint32_t(cz)) << 2;
  }
  std::vector<std::int32_t> order(cell_.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return key[std::size_t(a)] < key[std::size_t(b)]; });
  return order;
}

}  // namespace stresslet
