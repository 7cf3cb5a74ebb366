#pragma once
/// Which solid weights go with which coupling operator.
#include <string_view>

namespace stresslet {

/// Whether the operator is stable up to the largest weight of this law. Both names must be in their lists.
bool bears(std::string_view coupling_operator, std::string_view weight);

/// viscosity-scaled where the operator bears it, noble-torczynski elsewhere.
std::string_view default_weight(std::string_view coupling_operator);

}  // namespace stresslet
