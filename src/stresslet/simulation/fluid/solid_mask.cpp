#include "stresslet/simulation/fluid/solid_mask.hpp"

#include <algorithm>
#include <cmath>

#include "stresslet/io/voxel_file.hpp"
#include "stresslet/simulation/case_refusals.hpp"

namespace stresslet {

namespace {

using Point = std::array<double, 3>;

/// Sets the cells whose centres lie in a body with these bounds, in cells from the corner of the domain. `inside` gets
/// a centre, shifted by whole periods.
class Voxeliser {
 public:
  Voxeliser(const Grid& grid, double cell, std::vector<std::uint8_t>& mask) : grid_(grid), cell_(cell), mask_(mask) {}

  template <class Inside>
  void fill(const Point& low, const Point& high, Inside&& inside) {
    Cells first, last;
    for (std::size_t a = 0; a < 3; ++a) {
      first[a] = int(std::floor(low[a] / cell_ - 0.5));
      last[a] = int(std::ceil(high[a] / cell_ - 0.5));
      if (grid_.closure[a] == Closure::periodic) continue;
      first[a] = std::max(first[a], 0);
      last[a] = std::min(last[a], grid_.size[a] - 1);
    }
    for (int z = first[2]; z <= last[2]; ++z)
      for (int y = first[1]; y <= last[1]; ++y)
        for (int x = first[0]; x <= last[0]; ++x)
          if (inside(Point{(x + 0.5) * cell_, (y + 0.5) * cell_, (z + 0.5) * cell_})) mask_[number({x, y, z})] = 1;
  }

 private:
  std::size_t number(Cells c) const {
    const Cells& n = grid_.size;
    for (std::size_t a = 0; a < 3; ++a) c[a] = (c[a] % n[a] + n[a]) % n[a];
    return cell_number(n, c);
  }

  const Grid& grid_;
  double cell_;
  std::vector<std::uint8_t>& mask_;
};

void fill_spheres(Voxeliser& voxeliser, const std::vector<std::vector<double>>& spheres) {
  for (const auto& s : spheres) {
    const double r = s[3];
    voxeliser.fill({s[0] - r, s[1] - r, s[2] - r}, {s[0] + r, s[1] + r, s[2] + r}, [&](const Point& p) {
      const double dx = p[0] - s[0], dy = p[1] - s[1], dz = p[2] - s[2];
      return dx * dx + dy * dy + dz * dz <= r * r;
    });
  }
}

void fill_cylinders(Voxeliser& voxeliser, const std::vector<std::vector<double>>& cylinders, std::size_t axis,
                    const Point& box) {
  const std::size_t a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
  for (const auto& c : cylinders) {
    const double r = c[2];
    Point low{}, high = box;
    low[a] = c[0] - r, high[a] = c[0] + r, low[b] = c[1] - r, high[b] = c[1] + r;
    voxeliser.fill(low, high, [&](const Point& p) {
      const double da = p[a] - c[0], db = p[b] - c[1];
      return da * da + db * db <= r * r;
    });
  }
}

void fill_boxes(Voxeliser& voxeliser, const std::vector<std::vector<double>>& boxes) {
  for (const auto& b : boxes)
    voxeliser.fill({b[0], b[1], b[2]}, {b[3], b[4], b[5]}, [&](const Point& p) {
      for (std::size_t a = 0; a < 3; ++a)
        if (p[a] < b[a] || p[a] > b[a + 3]) return false;
      return true;
    });
}

}  // namespace

std::vector<std::uint8_t> solid_mask(const FluidCase& settled, const Grid& grid) {
  if (!settled.solid) return {};
  const SolidInput& solid = *settled.solid;
  const Cells& n = grid.size;
  std::vector<std::uint8_t> mask(cell_count(n), 0);
  if (solid.file) mask = read_voxels(solid.file->text, n, settled.where("solid.file"));
  const Vec3<double> box = settled.box();
  Voxeliser voxeliser(grid, 1.0 / double(settled.domain.resolution), mask);
  if (solid.spheres) fill_spheres(voxeliser, *solid.spheres);
  if (solid.cylinders)
    fill_cylinders(voxeliser, *solid.cylinders, std::size_t(solid.cylinder_axis), {box.x, box.y, box.z});
  if (solid.boxes) fill_boxes(voxeliser, *solid.boxes);
  if (std::all_of(mask.begin(), mask.end(), [](std::uint8_t s) { return s != 0; }))
    refuse(settled.where("solid"), "no cell is left to the fluid", "the solid bodies fill the whole domain",
           "make them smaller, or check their units: lengths are in L");
  return mask;
}

}  // namespace stresslet
