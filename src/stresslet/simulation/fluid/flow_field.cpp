#include "stresslet/simulation/fluid/flow_field.hpp"

#include <cmath>

#include "stresslet/lattice/boundary/interpolation.hpp"
#include "stresslet/simulation/fluid/case_choices.hpp"

namespace stresslet {

FlowField::FlowField(const FluidSetup& setup)
    : size_(setup.grid.size),
      closure_(setup.grid.closure),
      faces_(setup.faces),
      shear_velocity_(setup.shear_velocity_lu),
      solid_(setup.solid),
      cells_(cell_count(size_)) {}

void FlowField::measure(Fluid& fluid, ThreadTeam& team) {
  if (closure_[1] == Closure::sheared) shear_offset_ = fluid.shear_offset();
  fluid.measure(team, {0, 0, 0}, {size_[0] - 1, size_[1] - 1, size_[2] - 1}, {1, 1, 1},
                [&](const Cells& c, const CellState& state) { cells_[number(c)] = is_solid(c) ? CellState{} : state; });
}

/// Across the sheared face: the image above lies `shear_offset` further along x and is faster by `shear_velocity`.
VelocityAt FlowField::beside_in_image(const Cells& c, int side) const {
  const double x = c[0] - side * shear_offset_, whole = std::floor(x), t = x - whole;
  const std::array<double, 4> weights = CubicInterpolation::weights(t);
  const int first = int(std::fmod(whole, size_[0])) - 1 + 2 * size_[0];
  VelocityAt found{double(side), {side * shear_velocity_, 0, 0}};
  for (int k = 0; k < 4; ++k)
    found.velocity +=
        weights[std::size_t(k)] * (*this)[{(first + k) % size_[0], side > 0 ? 0 : size_[1] - 1, c[2]}].velocity;
  return found;
}

VelocityAt FlowField::beside(const Cells& c, std::size_t axis, int side) const {
  Cells next = c;
  next[axis] += side;
  if (next[axis] < 0 || next[axis] >= size_[axis]) {
    if (closure_[axis] == Closure::open) {
      const FaceSetup& face = faces_[axis][side > 0];
      if (boundary_kind(face.law) != BoundaryKind::wall) return {};
      return {0.5 * side, face.velocity_lu};
    }
    if (closure_[axis] == Closure::sheared) return beside_in_image(c, side);
    next[axis] = (next[axis] + size_[axis]) % size_[axis];
  }
  if (is_solid(next)) return {0.5 * side, {}};
  return {double(side), (*this)[next].velocity};
}

Vec3<double> FlowField::derivative_along(const Cells& c, std::size_t axis) const {
  VelocityAt points[2] = {beside(c, axis, -1), beside(c, axis, 1)};
  for (int k : {0, 1}) {
    if (points[k].offset != 0) continue;
    // On an opening: one-sided, with the second point on the same side as the first.
    const int inwards = k == 0 ? 1 : -1;
    const VelocityAt& near = points[1 - k];
    if (std::abs(near.offset) != 1) return {};
    Cells next = c;
    next[axis] += inwards;
    points[k] = beside(next, axis, inwards);
    points[k].offset += inwards;
    if (points[k].offset == inwards) return double(inwards) * (near.velocity - (*this)[c].velocity);
  }
  return derivative((*this)[c].velocity, points[0], points[1]);
}

SymTensor3<double> FlowField::strain_rate_from_velocities(const Cells& c) const {
  return strain_rate_of(derivative_along(c, 0), derivative_along(c, 1), derivative_along(c, 2));
}

}  // namespace stresslet
