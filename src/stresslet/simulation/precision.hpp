#pragma once
/// The words for the precision of a lattice.
#include "stresslet/io/schema.hpp"

namespace stresslet {

enum class Precision { floating64, floating32 };

template <>
struct Keywords<Precision> {
  static constexpr std::array<std::pair<std::string_view, Precision>, 2> names{
      {{"float64", Precision::floating64}, {"float32", Precision::floating32}}};
};

}  // namespace stresslet
