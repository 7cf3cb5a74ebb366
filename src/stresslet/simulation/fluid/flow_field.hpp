#pragma once
/// Density, velocity and strain rate of all cells at one time, in lattice units, and what lies beside each cell.
#include <cstdint>
#include <vector>

#include "stresslet/lattice/fluid.hpp"
#include "stresslet/rheology/velocity_gradient.hpp"

namespace stresslet {

class FlowField {
 public:
  explicit FlowField(const FluidSetup& setup);

  /// Reads the present state of the fluid; solid cells are at rest with density 1.
  void measure(Fluid& fluid, ThreadTeam& team);

  const Cells& size() const { return size_; }
  std::size_t number(const Cells& c) const { return cell_number(size_, c); }
  bool is_solid(const Cells& c) const { return !solid_.empty() && solid_[number(c)]; }
  const CellState& operator[](const Cells& c) const { return cells_[number(c)]; }

  /// Strain rate from differences of the velocities of neighbours and walls (velocity_gradient.hpp).
  SymTensor3<double> strain_rate_from_velocities(const Cells& c) const;

 private:
  VelocityAt beside(const Cells& c, std::size_t axis, int side) const;
  VelocityAt beside_in_image(const Cells& c, int side) const;
  Vec3<double> derivative_along(const Cells& c, std::size_t axis) const;

  Cells size_;
  std::array<Closure, 3> closure_;
  std::array<std::array<FaceSetup, 2>, 3> faces_;
  double shear_velocity_, shear_offset_ = 0;
  std::vector<std::uint8_t> solid_;
  std::vector<CellState> cells_;  // x fastest
};

}  // namespace stresslet
