#include "stresslet/simulation/fluid/case_choices.hpp"

#include <algorithm>
#include <type_traits>

#include "stresslet/lattice/boundary/interpolation.hpp"
#include "stresslet/lattice/boundary/laws.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/simulation/fluid/fields.hpp"
#include "stresslet/simulation/fluid/initial_fields.hpp"

namespace stresslet {

std::vector<std::string> stencil_names() { return Stencils::names(); }
std::vector<std::string> collision_law_names() { return CollisionLaws::names(); }

std::vector<std::string> body_force_law_names() {
  std::vector<std::string> names = ForcingLaws::names();
  std::erase(names, std::string(NoForce::name));
  return names;
}

std::vector<std::string> boundary_law_names() { return BoundaryLaws::names(); }

BoundaryKind boundary_kind(std::string_view law) {
  BoundaryKind kind = BoundaryKind::wall;
  BoundaryLaws::dispatch(law, [&](auto tag) {
    using Law = typename decltype(tag)::type;
    if constexpr (!Law::is_wall)
      kind = std::is_base_of_v<PressureOpening, Law> ? BoundaryKind::pressure : BoundaryKind::velocity;
  });
  return kind;
}

std::vector<std::string> shear_interpolation_names() { return ShearInterpolations::names(); }
std::vector<std::string> initial_field_names() { return InitialFields::names(); }

std::vector<std::string> field_names() {
  std::vector<std::string> names;
  for (const FieldKind& kind : field_kinds) names.emplace_back(kind.name);
  return names;
}

}  // namespace stresslet
