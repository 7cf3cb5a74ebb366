#pragma once
/// Diameter of one particle and the size class of the input it belongs to.
#include <cstdint>

namespace stresslet {

struct SizeClassed {
  double diameter;
  std::int32_t species;
  friend bool operator==(const SizeClassed&, const SizeClassed&) = default;
};

}  // namespace stresslet
