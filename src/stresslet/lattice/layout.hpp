#pragma once
/// Where the cells of one block lie in memory. A block is a box of cells with one layer of halo cells around it (none
/// in z for two-dimensional stencils). x is contiguous; every population has an array of its own.
///
///     index(x, y, z) = origin + x + pitch y + plane z,   x in [-1, nx], y in [-1, ny], z in [-1, nz]
///
/// The left halo cell of a row lies in the padding of the row before, so that a row costs nx + 2 cells, rounded up to
/// whole SIMD packs. Populations start `stagger` apart modulo a page, so that their streams do not meet in the same
/// cache sets.
#include <array>
#include <cstddef>

#include "stresslet/exec/aligned.hpp"

namespace stresslet {

/// Numbers of cells, or cell coordinates, along x, y, z.
using Cells = std::array<int, 3>;

/// Of a box of `size` cells; and the place of a cell in a list of them, x fastest.
inline std::size_t cell_count(const Cells& size) {
  return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
}
inline std::size_t cell_number(const Cells& size, const Cells& c) {
  return std::size_t(c[0]) + std::size_t(size[0]) * (std::size_t(c[1]) + std::size_t(size[1]) * std::size_t(c[2]));
}

inline constexpr std::size_t row_alignment = 32;  // bytes

class BlockLayout {
 public:
  BlockLayout(const Cells& size, int halo_in_z, std::size_t value_size)
      : size_(size),
        halo_z_(halo_in_z),
        pitch_(rounded_up(std::size_t(size[0]) + 2, row_alignment / value_size)),
        plane_(pitch_ * (std::size_t(size[1]) + 2)),
        origin_(rounded_up(1, cache_line / value_size) + pitch_ + plane_ * std::size_t(halo_in_z)),
        stride_(stride(origin_ + plane_ * std::size_t(size[2] + halo_in_z) + cache_line / value_size, value_size)) {}

  const Cells& size() const { return size_; }
  int halo_in_z() const { return halo_z_; }
  std::size_t pitch() const { return pitch_; }
  std::size_t plane() const { return plane_; }
  /// Distance between the arrays of two populations.
  std::size_t stride() const { return stride_; }
  std::size_t cells() const { return cell_count(size_); }
  std::size_t rows() const { return std::size_t(size_[1]) * std::size_t(size_[2]); }

  std::size_t index(int x, int y, int z) const {
    return origin_ + std::size_t(std::ptrdiff_t(x) + std::ptrdiff_t(pitch_) * y + std::ptrdiff_t(plane_) * z);
  }
  std::size_t index(const Cells& c) const { return index(c[0], c[1], c[2]); }
  /// Distance to the neighbour at `c`.
  std::ptrdiff_t offset(const Cells& c) const {
    return c[0] + std::ptrdiff_t(pitch_) * c[1] + std::ptrdiff_t(plane_) * c[2];
  }

 private:
  static constexpr std::size_t rounded_up(std::size_t n, std::size_t grain) { return (n + grain - 1) / grain * grain; }
  static std::size_t stride(std::size_t cells, std::size_t value_size) {
    constexpr std::size_t page = 4096, stagger = 576;
    return (rounded_up(cells * value_size, page) + stagger) / value_size;
  }

  Cells size_;
  int halo_z_;
  std::size_t pitch_, plane_, origin_, stride_;
};

}  // namespace stresslet
