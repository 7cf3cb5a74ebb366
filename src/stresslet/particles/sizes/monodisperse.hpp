#pragma once
/// Spheres of one size.
#include <string_view>
#include <vector>

#include "stresslet/particles/sizes/checks.hpp"
#include "stresslet/particles/sizes/size_classed.hpp"

namespace stresslet {

struct Monodisperse {
  static constexpr std::string_view name = "monodisperse";
  static constexpr std::string_view summary = "spheres of one diameter";

  struct Params {
    double diameter = 1;
  };

  static void validate(const Params& p) { require_positive(p.diameter, "diameter"); }

  static std::vector<SizeClassed> sizes(const Params& p, std::size_t count) {
    validate(p);
    return std::vector<SizeClassed>(count, {p.diameter, 0});
  }
};

}  // namespace stresslet
