#pragma once
/// The words of a fluid case that choose a law, a field or an axis.
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "stresslet/io/schema.hpp"
#include "stresslet/simulation/precision.hpp"

namespace stresslet {

/// Names in the lists of lattice/laws.hpp and initial_fields.hpp. A body force needs a law other than "none".
std::vector<std::string> stencil_names();
std::vector<std::string> collision_law_names();
std::vector<std::string> body_force_law_names();
std::vector<std::string> boundary_law_names();
std::vector<std::string> shear_interpolation_names();
std::vector<std::string> initial_field_names();
/// Fields that can be written (fields.hpp).
std::vector<std::string> field_names();

/// What a boundary law prescribes.
enum class BoundaryKind { wall, velocity, pressure };
BoundaryKind boundary_kind(std::string_view law);

enum class Axis { x, y, z };

template <>
struct Keywords<Axis> {
  static constexpr std::array<std::pair<std::string_view, Axis>, 3> names{
      {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}}};
};

}  // namespace stresslet
