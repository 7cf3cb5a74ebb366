#include "stresslet/particles/sizes/discrete.hpp"

#include <algorithm>
#include <numeric>

#include "stresslet/particles/sizes/checks.hpp"

namespace stresslet {

namespace {

std::vector<double> number_fractions(const Discrete::Params& p) {
  std::vector<double> fraction = p.number_shares;
  if (fraction.empty())
    for (std::size_t k = 0; k < p.diameters.size(); ++k)
      fraction.push_back(p.volume_shares[k] / (p.diameters[k] * p.diameters[k] * p.diameters[k]));
  const double sum = std::accumulate(fraction.begin(), fraction.end(), 0.0);
  for (double& f : fraction) f /= sum;
  return fraction;
}

std::vector<std::size_t> counts_by_largest_remainder(const std::vector<double>& fraction, std::size_t count) {
  std::vector<std::size_t> counts, order(fraction.size());
  std::vector<double> remainder;
  for (const double f : fraction) {
    const double exact = f * double(count);
    counts.push_back(std::size_t(exact));
    remainder.push_back(exact - std::floor(exact));
  }
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return remainder[a] > remainder[b]; });
  const std::size_t given = std::accumulate(counts.begin(), counts.end(), std::size_t(0));
  for (std::size_t k = 0; given + k < count; ++k) ++counts[order[k % order.size()]];
  return counts;
}

}  // namespace

void Discrete::validate(const Params& p) {
  if (p.diameters.empty())
    throw InputError({"", "no diameters", "a discrete size distribution needs at least one", "list the diameters"});
  for (const double d : p.diameters) require_positive(d, "diameter");
  if (p.number_shares.empty() == p.volume_shares.empty())
    throw InputError({"", p.number_shares.empty() ? "neither number nor volume shares" : "number and volume shares",
                      "the shares follow from exactly one of them", "give number_shares or volume_shares"});
  if (p.volume_shares.empty())
    require_shares(p.number_shares, p.diameters.size(), "number shares");
  else
    require_shares(p.volume_shares, p.diameters.size(), "volume shares");
}

std::vector<SizeClassed> Discrete::sizes(const Params& p, std::size_t count) {
  validate(p);
  const std::vector<double> fraction = number_fractions(p);
  const std::vector<std::size_t> counts = counts_by_largest_remainder(fraction, count);
  std::vector<SizeClassed> sizes;
  sizes.reserve(count);
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts[k] == 0 && fraction[k] > 0)
      throw InputError({"", "no particle of diameter " + std::to_string(p.diameters[k]),
                        "its number share is " + std::to_string(fraction[k]) + " of only " + std::to_string(count),
                        "raise the number of particles or leave this size out"});
    sizes.insert(sizes.end(), counts[k], {p.diameters[k], std::int32_t(k)});
  }
  return sizes;
}

}  // namespace stresslet
