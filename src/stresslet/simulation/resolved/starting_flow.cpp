#include "stresslet/simulation/resolved/starting_flow.hpp"

#include <algorithm>
#include <utility>

#include "stresslet/coupling/covered_cell.hpp"
#include "stresslet/coupling/spans.hpp"

namespace stresslet {

namespace {

Vec3<double> arm_to(const Cells& cell, const SphereImage& image) {
  return Vec3<double>{double(cell[0]), double(cell[1]), double(cell[2])} - image.centre;
}

}  // namespace

StartingFlow::StartingFlow(const Grid& grid, double shear_offset, double velocity_difference,
                           std::vector<ResolvedSphere> spheres)
    : size_(grid.size),
      gradient_(velocity_difference / grid.size[1]),
      spheres_(std::move(spheres)),
      image_of_(cell_count(grid.size), -1) {
  for (std::size_t k = 0; k < spheres_.size(); ++k)
    append_images(grid, spheres_[k], std::int32_t(k), spheres_[k].radius, shear_offset, velocity_difference, images_);
  for (std::size_t k = 0; k < images_.size(); ++k) mark_cells_of(k);
}

void StartingFlow::mark_cells_of(std::size_t k) {
  const SphereImage& image = images_[k];
  const auto cells = [&](std::size_t axis, double centre) {
    const CellRange range = integers_within(centre, image.radius);
    return CellRange{std::max(range.begin, 0), std::min(range.end, size_[axis])};
  };
  const CellRange xs = cells(0, image.centre.x), ys = cells(1, image.centre.y), zs = cells(2, image.centre.z);
  for (int z = zs.begin; z < zs.end; ++z)
    for (int y = ys.begin; y < ys.end; ++y)
      for (int x = xs.begin; x < xs.end; ++x) {
        const Vec3<double> arm = arm_to({x, y, z}, image);
        if (dot(arm, arm) < image.radius * image.radius) image_of_[cell_number(size_, {x, y, z})] = std::int32_t(k);
      }
}

CellState StartingFlow::operator()(const Cells& cell) const {
  CellState state;
  const std::int32_t inside = image_of_[cell_number(size_, cell)];
  if (inside < 0) {
    state.velocity.x = gradient_ * (cell[1] - 0.5 * (size_[1] - 1));
    state.strain_rate.xy = 0.5 * gradient_;
    return state;
  }
  const SphereImage& image = images_[std::size_t(inside)];
  const ResolvedSphere& sphere = spheres_[std::size_t(image.sphere)];
  state.velocity = rigid_velocity(sphere.velocity, sphere.angular_velocity, arm_to(cell, image));
  state.velocity.x += image.velocity_jump;
  return state;
}

}  // namespace stresslet
