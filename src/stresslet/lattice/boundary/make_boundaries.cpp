#include "stresslet/lattice/boundary/make_boundaries.hpp"

#include "stresslet/lattice/boundary/links.hpp"
#include "stresslet/lattice/boundary/sheared.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

template <class Stencil, class T>
Boundaries<Stencil, T> make_boundaries(const FluidSetup& setup) {
  Boundaries<Stencil, T> boundaries;
  boundaries.push_back(std::make_unique<LinkBoundary<Stencil, T>>(exchange_links<Stencil>(setup.grid)));
  if (setup.grid.closure[1] == Closure::sheared)
    boundaries.push_back(std::make_unique<ShearedBoundary<Stencil, T>>(setup.grid, setup.shear_interpolation));
  const auto wall = [&](int axis, int side) -> std::optional<Vec3<double>> {
    const FaceSetup& face = setup.faces[std::size_t(axis)][side > 0];
    if (face.law != "half-way") return std::nullopt;
    return face.velocity_lu;
  };
  boundaries.push_back(std::make_unique<LinkBoundary<Stencil, T>>(half_way_links<Stencil>(setup.grid, wall)));
  return boundaries;
}

template Boundaries<D3Q19, double> make_boundaries<D3Q19, double>(const FluidSetup&);
template Boundaries<D3Q19, float> make_boundaries<D3Q19, float>(const FluidSetup&);
template Boundaries<D2Q9, double> make_boundaries<D2Q9, double>(const FluidSetup&);
template Boundaries<D3Q27, double> make_boundaries<D3Q27, double>(const FluidSetup&);

}  // namespace stresslet
