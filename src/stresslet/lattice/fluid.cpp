#include "stresslet/lattice/fluid_of.hpp"

namespace stresslet {

std::unique_ptr<Fluid> Fluid::make(const FluidSetup& setup) {
  if (!CollisionLaws::contains(setup.collision) || !ForcingLaws::contains(setup.forcing))
    throw std::invalid_argument("unknown collision or forcing law");
  if (setup.single_precision && setup.stencil != D3Q19::name)
    throw std::invalid_argument("single precision is built for D3Q19 only");
  if (setup.single_precision) return std::make_unique<FluidOf<D3Q19, float>>(setup);
  std::unique_ptr<Fluid> fluid;
  Stencils::dispatch(setup.stencil,
                     [&](auto s) { fluid = std::make_unique<FluidOf<typename decltype(s)::type, double>>(setup); });
  if (!fluid) throw std::invalid_argument("unknown stencil");
  return fluid;
}

}  // namespace stresslet
