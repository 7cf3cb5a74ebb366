#pragma once
/// The fluid of a suspension at time zero, in lattice units: the mean shear flow, and in cells whose centre lies in a
/// sphere the motion of that sphere. The fluid has the inertia of that volume (`own_mass` of ParticleState), so that
/// the sphere would lose its velocity in a step otherwise.
#include <cstdint>
#include <vector>

#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/lattice/cell_state.hpp"

namespace stresslet {

class StartingFlow {
 public:
  /// `velocity_difference` between the faces across y; the image above a sheared face is displaced by `shear_offset`.
  StartingFlow(const Grid& grid, double shear_offset, double velocity_difference, std::vector<ResolvedSphere> spheres);

  CellState operator()(const Cells& cell) const;

 private:
  void mark_cells_of(std::size_t image);

  Cells size_;
  double gradient_;
  std::vector<ResolvedSphere> spheres_;
  std::vector<SphereImage> images_;
  std::vector<std::int32_t> image_of_;  ///< [cell]: the one that its centre lies in, or -1
};

}  // namespace stresslet
