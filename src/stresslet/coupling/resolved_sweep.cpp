#include "stresslet/coupling/resolved_sweep.hpp"

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/solid_row.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

namespace {

template <class Stencil, class T, class Collision, class Forcing, class Operator>
void resolved_sweep(const Lattice<Stencil, T>& lattice, int block, const RowExchange<Stencil, T>* across_x,
                    const CoveredRuns<T>& covered, const std::vector<ResolvedSphere>& spheres, std::size_t first,
                    std::size_t last) {
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const int nx = layout.size()[0], ny = layout.size()[1];
  constexpr int width = CoveredRuns<T>::width;
  SolidRow<T> solid(nx);
  RowSweep<Stencil, T, Collision, Forcing> fluid(populations, lattice.arrangement, lattice.input);
  for (std::size_t row = first; row < last; ++row) {
    const Range runs = covered.runs_of_row(block, row);
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      const SphereImage& image = covered.images()[std::size_t(run.image)];
      solid.add(run, covered.drag(run), image, spheres[std::size_t(image.sphere)]);
    }
    const int y = int(row) % ny, z = int(row) / ny;
    if (across_x) across_x->bring_in(block, y, z);
    fluid.start(layout.index(0, y, z));
    for (int x = 0; x < nx; x += width) {
      if (x % fluid.line == 0) fluid.prefetch(x);
      if (runs.begin < runs.end && solid.is_covered(x))
        fluid.step(
            x, std::min(width, nx - x), [&](auto& f, auto& rates, const auto& force) __attribute__((always_inline)) {
              Operator::template collide<Collision, Forcing>(f, rates, force, solid.cell(x));
            });
      else
        fluid.step(x, std::min(width, nx - x));
    }
    if (across_x) across_x->bring_out(block, y, z);
    for (std::size_t k = runs.begin; k < runs.end; ++k) solid.clear(covered.runs()[k]);
  }
}

}  // namespace

template <class Stencil, class T>
ResolvedSweep<Stencil, T> resolved_sweep_for(std::string_view collision, std::string_view coupling_operator,
                                             bool forced) {
  ResolvedSweep<Stencil, T> found = nullptr;
  CollisionLaws::dispatch(collision, [&](auto c) {
    CouplingOperators::dispatch(coupling_operator, [&](auto o) {
      using Collision = typename decltype(c)::type;
      using Operator = typename decltype(o)::type;
      found = forced ? resolved_sweep<Stencil, T, Collision, Guo, Operator>
                     : resolved_sweep<Stencil, T, Collision, NoForce, Operator>;
    });
  });
  return found;
}

template ResolvedSweep<D3Q19, double> resolved_sweep_for<D3Q19, double>(std::string_view, std::string_view, bool);
template ResolvedSweep<D3Q19, float> resolved_sweep_for<D3Q19, float>(std::string_view, std::string_view, bool);

}  // namespace stresslet
