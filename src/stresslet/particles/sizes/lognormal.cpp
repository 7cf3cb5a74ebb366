#include "stresslet/particles/sizes/lognormal.hpp"

#include <algorithm>
#include <numbers>

#include "stresslet/particles/sizes/checks.hpp"

namespace stresslet {

namespace {

constexpr double least_probability = 1e-6;

double normal_distribution(double t) { return 0.5 * std::erfc(-t / std::numbers::sqrt2); }

/// Probability that a normal variable lies in [low, high], without cancellation far above the mean.
double normal_probability(double low, double high) {
  return low > 0 ? normal_distribution(-low) - normal_distribution(-high)
                 : normal_distribution(high) - normal_distribution(low);
}

/// The t in [low, high] below which `probability` of that interval's lies.
double quantile(double low, double high, double probability) {
  double below = low, above = high;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (below + above);
    (normal_probability(low, middle) < probability ? below : above) = middle;
  }
  return 0.5 * (below + above);
}

struct Cut {
  double low, high;
};

Cut cut(const Lognormal::Params& p) {
  return {std::log(p.smallest_diameter / p.median_diameter) / p.log_standard_deviation,
          std::log(p.largest_diameter / p.median_diameter) / p.log_standard_deviation};
}

}  // namespace

void Lognormal::validate(const Params& p) {
  require_positive(p.median_diameter, "median diameter");
  require_positive(p.log_standard_deviation, "log standard deviation");
  require_positive(p.smallest_diameter, "smallest diameter");
  require_positive(p.largest_diameter, "largest diameter");
  if (p.smallest_diameter >= p.largest_diameter)
    throw InputError({"",
                      "smallest diameter " + std::to_string(p.smallest_diameter) + ", largest diameter " +
                          std::to_string(p.largest_diameter),
                      "the cut distribution is empty", "give smallest_diameter < largest_diameter"});
  if (const auto [low, high] = cut(p); normal_probability(low, high) < least_probability)
    throw InputError({"",
                      "less than one in a million of the lognormal distribution lies between " +
                          std::to_string(p.smallest_diameter) + " and " + std::to_string(p.largest_diameter),
                      "sizes would be set by the cuts, not by the distribution",
                      "move the median diameter or the bounds"});
}

std::vector<SizeClassed> Lognormal::sizes(const Params& p, std::size_t count) {
  validate(p);
  const auto [low, high] = cut(p);
  const double all = normal_probability(low, high);
  std::vector<SizeClassed> sizes;
  sizes.reserve(count);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = quantile(low, high, all * (double(k) + 0.5) / double(count));
    const double d = p.median_diameter * std::exp(p.log_standard_deviation * t);
    sizes.push_back({std::clamp(d, p.smallest_diameter, p.largest_diameter), 0});
  }
  return sizes;
}

}  // namespace stresslet
