#include "stresslet/simulation/stress_closure.hpp"

#include <algorithm>

namespace stresslet {

std::vector<double> closure_differences(const Series& series, std::size_t first_row) {
  const auto &summed = series["relative_viscosity"], &plane = series["relative_viscosity_through_plane"],
             &stored = series["stored_momentum"], &strain = series["strain"];
  std::vector<double> difference;
  for (std::size_t k = std::max<std::size_t>(first_row, 1); k < summed.size(); ++k)
    difference.push_back(summed[k] + (stored[k] - stored[k - 1]) / (strain[k] - strain[k - 1]) - plane[k]);
  return difference;
}

}  // namespace stresslet
