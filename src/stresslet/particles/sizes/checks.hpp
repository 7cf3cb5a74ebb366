#pragma once
/// Checks shared by the size distributions.
#include <cmath>
#include <string>
#include <vector>

#include "stresslet/base/error.hpp"

namespace stresslet {

/// Throws InputError unless `value` is a positive number; `what` names it ("diameter").
inline void require_positive(double value, const std::string& what) {
  if (std::isfinite(value) && value > 0) return;
  throw InputError({"", what + " = " + std::to_string(value), "sizes are positive numbers", "give a positive " + what});
}

/// Throws InputError unless every share is a number >= 0, their sum is positive and there is one per diameter.
inline void require_shares(const std::vector<double>& shares, std::size_t diameters, const std::string& what) {
  if (shares.size() != diameters)
    throw InputError({"",
                      std::to_string(shares.size()) + " " + what + " for " + std::to_string(diameters) + " diameters",
                      "each diameter has one share", "give both lists the same length"});
  double sum = 0;
  for (const double share : shares) {
    if (!std::isfinite(share) || share < 0)
      throw InputError({"", what + " contain " + std::to_string(share), "a share is a number that is not negative",
                        "give shares >= 0; only their ratios count"});
    sum += share;
  }
  if (!(sum > 0))
    throw InputError({"", "all " + what + " are zero", "no particle would exist", "give at least one positive share"});
}

}  // namespace stresslet
