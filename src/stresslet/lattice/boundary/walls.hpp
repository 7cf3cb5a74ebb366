#pragma once
/// Plane walls: bounce-back half-way between the last cells and their halo. A population that leaves cell x along c_j
/// comes back along -c_j as
///   f_opposite(j) = f'_j - 2 w_j rho c_j.u_wall / cs^2,   rho = 1 (rest density),   Ladd, J. Fluid Mech. 271 (1994)
///   285.
/// Half-way: one step later. Full-way: two steps later, after a stay in a wall cell. Same steady flow; the extra delay
/// makes full-way walls less accurate in unsteady flow, and they keep a second set of populations.
/// The rest density keeps mass exact: the corrections of a wall that moves along itself sum to zero in every cell.
///
/// Errors: steady shear flow along the wall is exact at any relaxation time; of Poiseuille flow the wall seems to lie
/// off by what the magic parameter leaves (collision/trt.hpp). A wall may not move through itself (normal velocity):
/// that would pump mass.
#include <string_view>

namespace stresslet {

struct HalfWay {
  static constexpr std::string_view name = "half-way";
  static constexpr std::string_view summary = "wall half a cell outside the last cells, at rest or moving along itself";
  static constexpr bool is_wall = true;
};

struct FullWay {
  static constexpr std::string_view name = "full-way";
  static constexpr std::string_view summary = "same wall through wall cells: one more step of delay, more memory";
  static constexpr bool is_wall = true;
};

/// What a wall of this velocity adds to the population that leaves along `j` when it reverses it.
template <class Stencil, class Velocity>
double wall_correction(int j, const Velocity& wall) {
  const auto& c = Stencil::velocity[j];
  return -6 * Stencil::weight[j] * (c[0] * wall.x + c[1] * wall.y + c[2] * wall.z);
}

}  // namespace stresslet
