#pragma once
/// The fields that a run writes: their names, units and values in the units of the program.
#include <array>
#include <string_view>
#include <vector>

#include "stresslet/io/field_file.hpp"
#include "stresslet/simulation/fluid/flow_field.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

struct FieldKind {
  std::string_view name, unit, description;
  int components;  ///< 1, 3, or 6 (xx, xy, xz, yy, yz, zz)
};

inline constexpr std::array<FieldKind, 6> field_kinds{{
    {"velocity", "U", "velocity", 3},
    {"pressure", "rho*U^2", "pressure above that of the reference density", 1},
    {"density", "rho", "density", 1},
    {"strain_rate", "U/L", "symmetric velocity gradient, from the populations", 6},
    {"viscous_stress", "rho*U^2", "2 mu S, from the populations", 6},
    {"solid", "1", "1 in solid cells", 1},
}};

/// The cells of `box` at one time, the fields named in `names`.
FieldFile make_fields(const FlowField& field, const FluidPlan& plan, const std::vector<std::string>& names,
                      const CellBox& box, std::int64_t step);

}  // namespace stresslet
