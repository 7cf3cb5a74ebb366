#include "stresslet/simulation/resolved/fluid_profile.hpp"

#include <limits>

#include "stresslet/simulation/stored.hpp"

namespace stresslet {

void FluidProfile::add(const std::vector<FreeFluid>& planes) {
  for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] += planes[k];
}

std::vector<double> FluidProfile::height() const {
  std::vector<double> middle(sums_.size());
  for (std::size_t k = 0; k < middle.size(); ++k) middle[k] = (double(k) + 0.5) * cell_;
  return middle;
}

std::vector<double> FluidProfile::velocity() const {
  std::vector<double> mean(sums_.size());
  for (std::size_t k = 0; k < mean.size(); ++k)
    mean[k] = sums_[k].cells > 0 ? cell_ / step_ * sums_[k].velocity / sums_[k].cells
                                 : std::numeric_limits<double>::quiet_NaN();
  return mean;
}

void FluidProfile::put_into(ResultsFolder& results) const {
  results.set_profile(
      {"fluid_height", "d", "middle of the plane of cells, along the velocity gradient", {sums_.size()}, height()});
  results.set_profile({"fluid_velocity",
                       "d*shear_rate",
                       "velocity u_x of the fluid that no sphere touches, mean over plane and averaging window",
                       {sums_.size()},
                       velocity()});
}

void FluidProfile::add_to(Checkpoint& checkpoint) const {
  std::vector<double> cells, velocity;
  for (const FreeFluid& f : sums_) {
    cells.push_back(f.cells);
    velocity.push_back(f.velocity);
  }
  checkpoint.arrays["fluid_profile_cells"] = std::move(cells);
  checkpoint.arrays["fluid_profile_velocity"] = std::move(velocity);
}

void FluidProfile::restore(const Checkpoint& c) {
  const auto cells = stored<std::vector<double>>(c.arrays, "fluid_profile_cells"),
             velocity = stored<std::vector<double>>(c.arrays, "fluid_profile_velocity");
  for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k] = {cells.at(k), velocity.at(k)};
}

}  // namespace stresslet
