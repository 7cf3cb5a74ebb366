#pragma once
/// Automatic start of the steady state: the marginal standard error rule on means of five, MSER-5
/// (White, Simulation 69 (1997) 323; White, Cobb & Spratt, Proc. Winter Simulation Conf. 2000, 755).
///
/// Of m means of five, drop the first d that minimise sum_{j >= d} (Y_j - mean_d)^2 / (m - d)^2: dropping pays while it
/// lowers the spread faster than it shortens the series. At most half is dropped; a minimum at that bound means that
/// the series still drifts.
#include <cstddef>
#include <span>

namespace stresslet {

struct SteadyState {
  std::size_t begin = 0;  ///< first sample to average
  bool reached = false;   ///< false where the series still drifts, or has fewer than 50 samples
};

SteadyState find_steady_state(std::span<const double> series);

}  // namespace stresslet
