#pragma once
/// Which solid weights go with which coupling operator.
#include <string>
#include <string_view>

namespace stresslet {

/// Whether the operator is stable up to the largest weight of this law. Both names must be in their lists.
bool bears(std::string_view coupling_operator, std::string_view weight);

/// Throws InputError where the operator does not bear the weight; `where` it was given and what to do, in the caller's
/// words.
void require_borne(const std::string& coupling_operator, const std::string& weight, const std::string& where,
                   const std::string& fix);

/// viscosity-scaled where the operator bears it, noble-torczynski elsewhere.
std::string_view default_weight(std::string_view coupling_operator);

}  // namespace stresslet
