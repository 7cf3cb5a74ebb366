#pragma once
/// How closely the fluid is followed: the top-level key `fidelity` chooses the kind of case, and with it the sections.
#include <array>
#include <string_view>
#include <utility>

#include "stresslet/io/input_document.hpp"
#include "stresslet/io/schema.hpp"

namespace stresslet {

enum class Fidelity {
  lubricated,  ///< particles with pair lubrication, no resolved fluid (case.hpp)
  fluid,       ///< fluid without particles (fluid/case.hpp)
  resolved     ///< particles in resolved fluid
};

template <>
struct Keywords<Fidelity> {
  static constexpr std::array<std::pair<std::string_view, Fidelity>, 3> names{
      {{"lubricated", Fidelity::lubricated}, {"fluid", Fidelity::fluid}, {"resolved", Fidelity::resolved}}};
};

inline constexpr const char* fidelity_key = "fidelity";

/// Reads the key; lubricated where it is not given. Throws InputError for anything that no case can be made of.
Fidelity fidelity_of(InputDocument& document);

}  // namespace stresslet
