#include "stresslet/lattice/boundary/face_walls.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "stresslet/lattice/boundary/laws.hpp"

namespace stresslet {

namespace {

bool is_wall(const FaceSetup& face) {
  bool wall = false;
  BoundaryLaws::dispatch(face.law, [&](auto law) { wall = decltype(law)::type::is_wall; });
  return wall;
}

void check_face(const FaceSetup& face, int axis, int side, int cells) {
  const std::string where = fmt::format("{} face of {}", side ? "upper" : "lower", "xyz"[axis]);
  if (!BoundaryLaws::contains(face.law))
    throw std::invalid_argument(fmt::format("unknown boundary law '{}' on the {}", face.law, where));
  const Vec3<double>& u = face.velocity_lu;
  const double normal = axis == 0 ? u.x : axis == 1 ? u.y : u.z;
  if (is_wall(face)) {
    if (normal != 0)
      throw std::invalid_argument(fmt::format(
          "the wall on the {} moves through itself (its mass would not be conserved): remove the normal component, or "
          "use the law 'velocity'",
          where));
    return;
  }
  if (std::abs(normal) >= 1 || !(face.density_lu > 0))
    throw std::invalid_argument(fmt::format(
        "the opening on the {} needs a positive density and a normal velocity below one cell per step", where));
  if (cells < 2)
    throw std::invalid_argument(fmt::format(
        "the opening on the {} needs two cells across (the layer of one face would be that of the other)", where));
}

}  // namespace

void check_boundaries(const FluidSetup& setup, int dimensions) {
  const Grid& grid = setup.grid;
  std::optional<int> opening;
  for (int a = 0; a < 3; ++a) {
    if (grid.closure[std::size_t(a)] != Closure::open) continue;
    if (a >= dimensions)
      throw std::invalid_argument("a two-dimensional stencil has no boundary across z: make it periodic");
    for (int side = 0; side < 2; ++side) {
      const FaceSetup& face = setup.faces[std::size_t(a)][std::size_t(side)];
      check_face(face, a, side, grid.size[std::size_t(a)]);
      if (is_wall(face)) continue;
      if (opening.value_or(a) != a)
        throw std::invalid_argument(fmt::format(
            "openings on faces of {} and {} (in their common edge neither has all the populations it needs): close one "
            "pair with walls or make it periodic",
            "xyz"[*opening], "xyz"[a]));
      opening = a;
    }
  }
  if (grid.closure[1] == Closure::sheared &&
      (grid.closure[0] != Closure::periodic || grid.closure[2] != Closure::periodic))
    throw std::invalid_argument(
        "sheared faces across y with boundaries across x or z (the image of a wall would move): make x and z periodic");
  if (setup.solid.empty()) return;
  const std::size_t layer = std::size_t(grid.size[0]), cells = layer * grid.size[1] * grid.size[2];
  if (setup.solid.size() != cells)
    throw std::invalid_argument(
        fmt::format("the mask of solid cells has {} values for {} cells", setup.solid.size(), cells));
  if (grid.closure[1] == Closure::sheared)
    for (int z = 0; z < grid.size[2]; ++z)
      for (int x = 0; x < grid.size[0]; ++x)
        if (is_solid(setup, {x, 0, z}) || is_solid(setup, {x, grid.size[1] - 1, z}))
          throw std::invalid_argument(
              fmt::format("solid cells at a sheared face, at x = {}, z = {} (they would move with the image): keep the "
                          "first and the "
                          "last layer in y free",
                          x, z));
}

std::optional<WallMet> wall_across(const FluidSetup& setup, const Cells& crossed) {
  std::optional<WallMet> met;
  for (std::size_t a = 0; a < 3; ++a) {
    if (crossed[a] == 0 || setup.grid.closure[a] != Closure::open) continue;
    const FaceSetup& face = setup.faces[a][crossed[a] > 0];
    if (!met && is_wall(face)) met = {face.law, face.velocity_lu};
  }
  if (met)
    for (std::size_t a = 0; a < 3; ++a)
      if (crossed[a] != 0 && setup.grid.closure[a] == Closure::open)
        (a == 0 ? met->velocity_lu.x : a == 1 ? met->velocity_lu.y : met->velocity_lu.z) = 0;
  return met;
}

bool is_solid(const FluidSetup& setup, const Cells& c) {
  return !setup.solid.empty() && setup.solid[cell_number(setup.grid.size, c)];
}

bool meets_solid(const FluidSetup& setup, const Cells& crossed, const Cells& target) {
  Cells met = target;
  for (std::size_t a = 0; a < 3; ++a) {
    if (crossed[a] == 0 || setup.grid.closure[a] == Closure::periodic) continue;
    if (!wall_across(setup, crossed)) return false;
    met[a] = crossed[a] > 0 ? setup.grid.size[a] - 1 : 0;
  }
  return is_solid(setup, met);
}

std::vector<CellAt> cells_before(const FluidSetup& setup, int axis, int side, const std::vector<BlockLayout>& layouts) {
  std::vector<CellAt> cells;
  const int last = side < 0 ? 0 : setup.grid.size[std::size_t(axis)] - 1;
  for_each_cell_in_order(setup.grid, [&](int block, const Cells& cell, const Cells& global) {
    if (global[std::size_t(axis)] == last && !is_solid(setup, global))
      cells.push_back({block, layouts[std::size_t(block)].index(cell)});
  });
  return cells;
}

std::vector<SolidRun> solid_runs(const FluidSetup& setup, const std::vector<BlockLayout>& layouts) {
  std::vector<SolidRun> runs;
  for_each_cell_in_order(setup.grid, [&](int block, const Cells& cell, const Cells& global) {
    if (!is_solid(setup, global)) return;
    const std::size_t index = layouts[std::size_t(block)].index(cell);
    if (!runs.empty() && runs.back().block == block && runs.back().first + runs.back().count == index)
      ++runs.back().count;
    else
      runs.push_back({block, index, 1});
  });
  return runs;
}

}  // namespace stresslet
