#pragma once
/// A few sizes, each with its share of the number or of the volume of particles. The species is the index of the size.
///
/// Volume shares v_k become number shares n_k ~ v_k / d_k^3: equal volumes of diameters 1 and 1.4 are 2.744 : 1 by
/// number. Counts follow by the method of the largest remainder, ties to the earlier size, so that each differs from
/// its exact value by less than one particle.
#include <string_view>
#include <vector>

#include "stresslet/particles/sizes/size_classed.hpp"

namespace stresslet {

struct Discrete {
  static constexpr std::string_view name = "discrete";
  static constexpr std::string_view summary = "a list of diameters with number or volume shares";

  struct Params {
    std::vector<double> diameters;
    std::vector<double> number_shares;  ///< relative; exactly one of the two lists is given
    std::vector<double> volume_shares;
  };

  static void validate(const Params& p);

  /// Particles in order of size class. InputError also where a size with a positive share would get no particle.
  static std::vector<SizeClassed> sizes(const Params& p, std::size_t count);
};

}  // namespace stresslet
