#pragma once
/// Error norms and orders of convergence.
#include <cmath>
#include <span>

namespace stresslet::validation {

/// p in error ~ (number of cells)^-p.
inline double observed_order(double coarse_cells, double coarse_error, double fine_cells, double fine_error) {
  return std::log(std::abs(coarse_error / fine_error)) / std::log(fine_cells / coarse_cells);
}

/// |value - exact| / |exact|, Euclidean norms.
inline double relative_l2_error(std::span<const double> value, std::span<const double> exact) {
  double difference = 0, norm = 0;
  for (std::size_t k = 0; k < value.size(); ++k) {
    difference += (value[k] - exact[k]) * (value[k] - exact[k]);
    norm += exact[k] * exact[k];
  }
  return std::sqrt(difference / norm);
}

/// Largest |value - exact|.
inline double largest_difference(std::span<const double> value, std::span<const double> exact) {
  double largest = 0;
  for (std::size_t k = 0; k < value.size(); ++k) {
    const double difference = std::abs(value[k] - exact[k]);
    if (!(difference <= largest)) largest = difference;  // keeps what is no number
  }
  return largest;
}

}  // namespace stresslet::validation
