#pragma once
/// Velocity profile of the fluid across the velocity gradient: the mean of u_x over the cells that no sphere touches,
/// plane of cells by plane, over the frames added.
#include <vector>

#include "stresslet/io/results_data.hpp"
#include "stresslet/io/results_folder.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"

namespace stresslet {

class FluidProfile {
 public:
  FluidProfile() = default;
  explicit FluidProfile(const ResolvedSetup& setup)
      : cell_(setup.cell), step_(setup.step()), sums_(std::size_t(setup.cells[1])) {}

  /// Adds one frame, ResolvedFlow::last_planes.
  void add(const std::vector<FreeFluid>& planes);

  std::vector<double> height() const;    ///< [plane] middle, d1
  std::vector<double> velocity() const;  ///< [plane] d1 x shear rate; NaN where there never was free fluid

  /// fluid_height and fluid_velocity.
  void put_into(ResultsFolder& results) const;

  void add_to(Checkpoint& checkpoint) const;
  void restore(const Checkpoint& checkpoint);

 private:
  double cell_ = 1, step_ = 1;
  std::vector<FreeFluid> sums_;
};

}  // namespace stresslet
