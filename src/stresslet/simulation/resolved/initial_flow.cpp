#include "stresslet/simulation/resolved/initial_flow.hpp"

#include <algorithm>

#include "stresslet/coupling/covered_cell.hpp"
#include "stresslet/coupling/spans.hpp"

namespace stresslet {

InitialFlow::InitialFlow(const Grid& grid, const MeanShear& shear, const std::vector<ResolvedSphere>& spheres)
    : size_(grid.size), gradient_(shear.velocity_difference / grid.size[1]), spheres_(spheres) {
  for (std::size_t k = 0; k < spheres.size(); ++k)
    append_images(grid, spheres[k], std::int32_t(k), spheres[k].radius, shear.offset, shear.velocity_difference,
                  images_);
  image_of_.assign(std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]), -1);
  const auto within = [&](int axis, const CellRange& range) {
    return CellRange{std::max(range.begin, 0), std::min(range.end, size_[std::size_t(axis)])};
  };
  for (std::size_t k = 0; k < images_.size(); ++k) {
    const Vec3<double>& centre = images_[k].centre;
    const double radius = images_[k].radius;
    const auto cells = [&](int axis, double at) { return within(axis, integers_within(at, radius)); };
    const CellRange xs = cells(0, centre.x), ys = cells(1, centre.y), zs = cells(2, centre.z);
    for (int z = zs.begin; z < zs.end; ++z)
      for (int y = ys.begin; y < ys.end; ++y)
        for (int x = xs.begin; x < xs.end; ++x) {
          const Vec3<double> arm = Vec3<double>{double(x), double(y), double(z)} - centre;
          if (dot(arm, arm) < radius * radius) image_of_[number({x, y, z})] = std::int32_t(k);
        }
  }
}

CellState InitialFlow::operator()(const Cells& cell) const {
  CellState state;
  const std::int32_t inside = image_of_[number(cell)];
  if (inside >= 0) {
    const SphereImage& image = images_[std::size_t(inside)];
    const ResolvedSphere& sphere = spheres_[std::size_t(image.sphere)];
    const Vec3<double> arm = Vec3<double>{double(cell[0]), double(cell[1]), double(cell[2])} - image.centre;
    state.velocity = rigid_velocity(sphere.velocity, sphere.angular_velocity, arm);
    state.velocity.x += image.velocity_jump;
    return state;
  }
  state.velocity.x = gradient_ * (cell[1] - 0.5 * (size_[1] - 1));
  state.strain_rate.xy = 0.5 * gradient_;
  return state;
}

}  // namespace stresslet
