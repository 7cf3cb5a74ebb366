#pragma once
/// Size distribution given as a table, as a sieve analysis gives it: row k holds a diameter d_k, ascending, and the
/// share of particles with diameters in (d_(k-1), d_k]; the share of the first row has exactly the diameter d_0.
///
/// The cumulative share is linear in d between rows. By number this spreads the particles of a row evenly over its
/// diameters; by volume it spreads their volume evenly, so their number density falls as d^-3:
///   number of row k ~ v_k (a + b) / (2 a^2 b^2),   quantile u: d = [a^-2 - u (a^-2 - b^-2)]^(-1/2),   a = d_(k-1), b =
///   d_k.
/// Not random: particle k of N takes the quantile (k + 1/2)/N by number. The species is the row.
#include <string_view>
#include <vector>

#include "stresslet/particles/sizes/size_classed.hpp"

namespace stresslet {

struct Table {
  static constexpr std::string_view name = "table";
  static constexpr std::string_view summary = "cumulative distribution by number or volume, linear between rows";

  enum class Basis { number, volume };

  struct Params {
    std::vector<double> diameters;
    std::vector<double> shares;  ///< relative
    Basis basis = Basis::number;
  };

  static void validate(const Params& p);

  /// Particles in ascending order of diameter.
  static std::vector<SizeClassed> sizes(const Params& p, std::size_t count);
};

}  // namespace stresslet
