#pragma once
/// Set-ups that tests of the fluid's boundaries share: every stencil, boxes between two faces of a law, a lively field.
#include "small_fluid.hpp"
#include "stresslet/lattice/boundary/laws.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet::testing {

struct StencilOf {
  std::string name;
  int dimensions;
};

inline std::vector<StencilOf> stencils() {
  std::vector<StencilOf> all;
  Stencils::for_each([&](auto s) {
    using Stencil = typename decltype(s)::type;
    all.push_back({std::string(Stencil::name), Stencil::dimensions});
  });
  return all;
}

inline bool is_wall(std::string_view law) {
  bool wall = false;
  BoundaryLaws::dispatch(law, [&](auto l) { wall = decltype(l)::type::is_wall; });
  return wall;
}

/// Faces of this law across `axis`, the rest periodic.
inline FluidSetup between_faces(const StencilOf& stencil, int axis, const std::string& law, const Cells& size) {
  FluidSetup setup = fluid_setup(stencil.name, size);
  setup.grid.closure[std::size_t(axis)] = Closure::open;
  for (FaceSetup& face : setup.faces[std::size_t(axis)]) face.law = law;
  return setup;
}

/// Some smooth field without symmetry.
inline CellState swirl(const Cells& c, bool flat) {
  const double x = 0.7 * c[0], y = 0.9 * c[1], z = flat ? 0 : 1.1 * c[2];
  return {1 + 0.01 * std::sin(x + 2 * y + z),
          {0.02 * std::sin(y - z), 0.03 * std::cos(x + z), flat ? 0 : 0.01 * std::sin(x - 2 * y)},
          {}};
}

}  // namespace stresslet::testing
