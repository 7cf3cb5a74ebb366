#include "stresslet/lattice/boundary/make_boundaries.hpp"

#include "stresslet/lattice/boundary/face_walls.hpp"
#include "stresslet/lattice/boundary/laws.hpp"
#include "stresslet/lattice/boundary/links.hpp"
#include "stresslet/lattice/boundary/sheared.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

template <class Stencil, class T>
void add_walls(const FluidSetup& setup, const std::vector<BlockLayout>& layouts, Boundaries<Stencil, T>& boundaries) {
  const auto half_way = half_way_links<Stencil>(setup.grid, [&](const Cells& crossed) -> std::optional<Vec3<double>> {
    const auto wall = wall_across(setup, crossed);
    if (!wall || wall->law != HalfWay::name) return std::nullopt;
    return wall->velocity_lu;
  });
  if (!half_way.empty()) boundaries.others.push_back(std::make_unique<LinkBoundary<Stencil, T>>(half_way));

  bool some = false;
  for (std::size_t a = 0; a < 3; ++a)
    for (const FaceSetup& face : setup.faces[a])
      some = some || (setup.grid.closure[a] == Closure::open && face.law == FullWay::name);
  if (!some) return;
  boundaries.others.push_back(std::make_unique<FullWayBoundary<Stencil, T>>(wall_links<Stencil>(
      setup, layouts, [&](int j, const Cells& crossed, const Cells& target) -> std::optional<double> {
        const auto wall = wall_across(setup, crossed);
        if (!wall || wall->law != FullWay::name || meets_solid(setup, crossed, target)) return std::nullopt;
        return wall_correction<Stencil>(j, wall->velocity_lu);
      })));
}

template <class Stencil, class T>
void add_solid(const FluidSetup& setup, const std::vector<BlockLayout>& layouts, Boundaries<Stencil, T>& boundaries) {
  if (setup.solid.empty()) return;
  auto links = wall_links<Stencil>(
      setup, layouts, [&](int j, const Cells& crossed, const Cells& target) -> std::optional<double> {
        if (!meets_solid(setup, crossed, target)) return std::nullopt;
        if (!setup.solid_velocity_lu) return 0;
        const auto& c = Stencil::velocity[j];
        return wall_correction<Stencil>(
            j, setup.solid_velocity_lu(
                   {target[0] + 0.5 * (1 - c[0]), target[1] + 0.5 * (1 - c[1]), target[2] + 0.5 * (1 - c[2])}));
      });
  boundaries.others.push_back(
      std::make_unique<SolidBoundary<Stencil, T>>(std::move(links), solid_runs(setup, layouts)));
}

template <class Stencil, class T>
void add_openings(const FluidSetup& setup, const std::vector<BlockLayout>& layouts,
                  Boundaries<Stencil, T>& boundaries) {
  for (int a = 0; a < 3; ++a)
    for (const int side : {-1, 1}) {
      if (setup.grid.closure[std::size_t(a)] != Closure::open) continue;
      const FaceSetup& face = setup.faces[std::size_t(a)][side > 0];
      BoundaryLaws::dispatch(face.law, [&](auto law) {
        using Law = typename decltype(law)::type;
        if constexpr (!Law::is_wall)
          boundaries.others.push_back(
              std::make_unique<OpeningBoundary<Stencil, T, Law>>(a, side, face, cells_before(setup, a, side, layouts)));
      });
    }
}

}  // namespace

template <class Stencil, class T>
Boundaries<Stencil, T> make_boundaries(const FluidSetup& setup, const Lattice<Stencil, T>& lattice) {
  check_boundaries(setup, Stencil::dimensions);
  std::vector<BlockLayout> layouts;
  for (const BlockBox& box : block_boxes(setup.grid))
    layouts.emplace_back(box.size, Populations<Stencil, T>::halo_in_z, sizeof(T));

  Boundaries<Stencil, T> boundaries;
  std::vector<LinkBox> links = exchange_links<Stencil>(setup.grid);
  boundaries.rows = RowExchange<Stencil, T>(links, lattice);
  boundaries.others.push_back(std::make_unique<LinkBoundary<Stencil, T>>(std::move(links)));
  if (setup.grid.closure[1] == Closure::sheared)
    boundaries.others.push_back(std::make_unique<ShearedBoundary<Stencil, T>>(setup.grid, setup.shear_interpolation));
  add_walls(setup, layouts, boundaries);
  add_solid(setup, layouts, boundaries);
  add_openings(setup, layouts, boundaries);
  return boundaries;
}

template Boundaries<D3Q19, double> make_boundaries<D3Q19, double>(const FluidSetup&, const Lattice<D3Q19, double>&);
template Boundaries<D3Q19, float> make_boundaries<D3Q19, float>(const FluidSetup&, const Lattice<D3Q19, float>&);
template Boundaries<D2Q9, double> make_boundaries<D2Q9, double>(const FluidSetup&, const Lattice<D2Q9, double>&);
template Boundaries<D3Q27, double> make_boundaries<D3Q27, double>(const FluidSetup&, const Lattice<D3Q27, double>&);

}  // namespace stresslet
