#pragma once
/// The fluid of a suspension at time zero, in lattice units: the mean shear flow, and in cells whose centre lies in a
/// sphere the motion of that sphere. The fluid has the inertia of that volume (`own_mass` of ParticleState), so that
/// the sphere would lose its velocity in a step otherwise.
#include <cstdint>
#include <vector>

#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/lattice/cell_state.hpp"

namespace stresslet {

/// Between the faces across y of a sheared domain, or zero.
struct MeanShear {
  double velocity_difference = 0;
  double offset = 0;  ///< of the image above
};

class InitialFlow {
 public:
  InitialFlow(const Grid& grid, const MeanShear& shear, const std::vector<ResolvedSphere>& spheres);

  CellState operator()(const Cells& cell) const;

 private:
  std::size_t number(const Cells& c) const {
    return std::size_t(c[0]) + std::size_t(size_[0]) * (std::size_t(c[1]) + std::size_t(size_[1]) * std::size_t(c[2]));
  }

  Cells size_;
  double gradient_;
  const std::vector<ResolvedSphere>& spheres_;
  std::vector<SphereImage> images_;
  std::vector<std::int32_t> image_of_;  ///< [cell]: the one that its centre lies in, or -1
};

}  // namespace stresslet
