#pragma once
/// Pair lubrication laws. If unsure use `complete`.
///
/// | law              | X | Y, B, C | arm     | background flow                    | balance of torque |
/// |------------------|---|---------|---------|------------------------------------|-------------------|
/// | none             |   |         |         |                                    | exact             |
/// | normal           | x |         | R       | cancels                            | exact             |
/// | complete         | x | x       | R       | cancels                            | exact             |
/// | grand-resistance | x | x       | a1 + a2 | enters through strain and rotation | to O(gap)         |
///
/// A law gives the coefficients of the dissipation function (pair_law.hpp), the lever arm, and whether the velocity
/// that the fluid itself has across the gap is subtracted from the relative velocity.
#include "stresslet/base/type_list.hpp"
#include "stresslet/lubrication/complete.hpp"
#include "stresslet/lubrication/grand_resistance.hpp"
#include "stresslet/lubrication/no_lubrication.hpp"
#include "stresslet/lubrication/normal_only.hpp"

namespace stresslet {

using LubricationLaws = TypeList<NoLubrication, NormalOnly, Complete, GrandResistance>;

/// Of the law of this name.
inline bool sees_background(std::string_view law) {
  bool sees = false;
  LubricationLaws::dispatch(law, [&](auto tag) { sees = decltype(tag)::type::sees_background; });
  return sees;
}

}  // namespace stresslet
