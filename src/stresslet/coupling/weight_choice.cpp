#include "stresslet/coupling/weight_choice.hpp"

#include <fmt/format.h>

#include "stresslet/base/error.hpp"
#include "stresslet/coupling/laws.hpp"

namespace stresslet {

bool bears(std::string_view coupling_operator, std::string_view weight) {
  double largest = 0, allowed = 0;
  SolidWeights::dispatch(weight, [&](auto w) { largest = decltype(w)::type::largest; });
  CouplingOperators::dispatch(coupling_operator, [&](auto o) { allowed = decltype(o)::type::largest_weight; });
  return largest <= allowed;
}

void require_borne(const std::string& coupling_operator, const std::string& weight, const std::string& where,
                   const std::string& fix) {
  if (!bears(coupling_operator, weight))
    throw InputError({where, fmt::format("the operator {} does not bear the weight {}", coupling_operator, weight),
                      "that weight comes close to 2, where this operator is stable up to 1", fix});
}

std::string_view default_weight(std::string_view coupling_operator) {
  return bears(coupling_operator, ViscosityScaledWeight::name) ? ViscosityScaledWeight::name
                                                               : NobleTorczynskiWeight::name;
}

}  // namespace stresslet
