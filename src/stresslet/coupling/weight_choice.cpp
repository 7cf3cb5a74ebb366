#include "stresslet/coupling/weight_choice.hpp"

#include "stresslet/coupling/laws.hpp"

namespace stresslet {

bool bears(std::string_view coupling_operator, std::string_view weight) {
  double largest = 0, allowed = 0;
  SolidWeights::dispatch(weight, [&](auto w) { largest = decltype(w)::type::largest; });
  CouplingOperators::dispatch(coupling_operator, [&](auto o) { allowed = decltype(o)::type::largest_weight; });
  return largest <= allowed;
}

std::string_view default_weight(std::string_view coupling_operator) {
  return bears(coupling_operator, ViscosityScaledWeight::name) ? ViscosityScaledWeight::name
                                                               : NobleTorczynskiWeight::name;
}

}  // namespace stresslet
