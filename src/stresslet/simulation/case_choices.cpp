#include "stresslet/simulation/case_choices.hpp"

#include "stresslet/dem/laws.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/simulation/schemes/laws.hpp"

namespace stresslet {

std::vector<std::string> normal_contact_law_names() { return NormalContactLaws::names(); }
std::vector<std::string> lubrication_law_names() { return LubricationLaws::names(); }
std::vector<std::string> time_scheme_names() { return TimeSchemes::names(); }

}  // namespace stresslet
