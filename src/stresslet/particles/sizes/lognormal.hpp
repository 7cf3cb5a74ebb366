#pragma once
/// Lognormal number distribution of diameters, cut at both ends:
///   P(diameter < d) = [Phi(t(d)) - Phi(t(d_s))] / [Phi(t(d_l)) - Phi(t(d_s))],   t(d) = ln(d / d_m) / s,
/// with Phi the normal distribution function, d_m the median diameter by number (before cutting), s the standard
/// deviation of ln d, and d_s, d_l the smallest and largest diameters.
///
/// Not random: particle k of N takes the quantile (k + 1/2)/N, so the same N always gives the same sizes, and sample
/// moments are as close to those of the distribution as N allows. One size class, species 0.
#include <string_view>
#include <vector>

#include "stresslet/particles/sizes/size_classed.hpp"

namespace stresslet {

struct Lognormal {
  static constexpr std::string_view name = "lognormal";
  static constexpr std::string_view summary = "lognormal by number between a smallest and a largest diameter";

  struct Params {
    double median_diameter = 1;
    double log_standard_deviation = 0.2;
    double smallest_diameter = 0.5;
    double largest_diameter = 2;
  };

  static void validate(const Params& p);

  /// Particles in ascending order of diameter.
  static std::vector<SizeClassed> sizes(const Params& p, std::size_t count);
};

}  // namespace stresslet
