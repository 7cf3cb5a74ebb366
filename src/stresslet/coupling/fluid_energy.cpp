#include "stresslet/coupling/fluid_energy.hpp"

#include <cmath>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {

namespace {

/// The solids in one cell: sums of alpha, alpha us and alpha us^2.
struct CellSolids {
  SharedDrag<double> shared;
  double drag_square = 0;
};

template <class T>
std::vector<CellSolids> solids_of_row(int nx, int block, std::size_t row, const CoveredRuns<T>& covered,
                                      const std::vector<ResolvedSphere>& spheres) {
  std::vector<CellSolids> cells{std::size_t(nx)};
  const Range runs = covered.runs_of_row(block, row);
  for (std::size_t k = runs.begin; k < runs.end; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const ResolvedSphere& sphere = spheres[std::size_t(image.sphere)];
    const T* drag = covered.drag(run);
    for (int x = run.cells.begin; x < run.cells.end; ++x) {
      const int along = x - run.global[0];
      const Vec3<double> arm{x - image.centre.x, run.global[1] - image.centre.y, run.global[2] - image.centre.z};
      Vec3<double> u = rigid_velocity(sphere.velocity, sphere.angular_velocity, arm);
      u.x += image.velocity_jump;
      CellSolids& cell = cells[std::size_t(run.x + along)];
      cell.shared.add(drag[along], u);
      cell.drag_square += drag[along] * dot(u, u);
    }
  }
  return cells;
}

/// sum n_i^2/w_i.
template <class Stencil>
double weighted_square(const CellPopulations<Stencil, double>& f, const Equilibrium<Stencil, double>& eq) {
  double sum = (f.rest - eq.rest()) * (f.rest - eq.rest()) / Stencil::weight[0];
  unroll<Stencil::pairs>([&](auto k) {
    constexpr int i = first_of_pair(k);
    const EvenOdd<double> target = eq.template pair<i>();
    const double even = f.pair[k].even - target.even, odd = f.pair[k].odd - target.odd;
    sum += (even * even + odd * odd) / (2 * Stencil::weight[i]);
  });
  return sum;
}

template <class Stencil, class T, class Collision, class Operator>
FluidEnergy row_energy(const Lattice<Stencil, T>& lattice, int block, std::size_t row, const CoveredRuns<T>& covered,
                       const std::vector<ResolvedSphere>& spheres, double shear_rate) {
  const auto& of_block = lattice.blocks[std::size_t(block)];
  const BlockLayout& layout = of_block.populations.layout();
  const int nx = layout.size()[0], ny = layout.size()[1], y = int(row) % ny, z = int(row) / ny;
  const std::vector<CellSolids> solids = solids_of_row(nx, block, row, covered, spheres);
  const double middle = 0.5 * (lattice.grid.size[1] - 1);
  const double height = of_block.origin[1] + y - middle;
  const double mean_flow = shear_rate * height;
  typename Collision::template Cell<Stencil, double> collision(lattice.input.rates);
  FluidEnergy sum;
  for (int x = 0; x < nx; ++x) {
    const CellPopulations<Stencil, double> before =
        incoming(of_block.populations, lattice.arrangement, layout.index(x, y, z));
    const Moments<double> m = moments_of(before);
    const double density = m.density();
    const Vec3<double> u_before = m.momentum / density;
    const Equilibrium<Stencil, double> eq(m.density_deviation, u_before);
    const CellSolids& cell = solids[std::size_t(x)];
    const CoveredCell<double> solid = covered_cell(cell.shared);

    CellPopulations<Stencil, double> after = before;
    Operator::template collide<Collision, NoForce>(after, collision, BodyForce<double>{},
                                                   CoveredCell<double>{solid.weight, u_before});
    sum.collisions += (weighted_square(before, eq) - weighted_square(after, eq)) / 6;

    const double held = Operator::exchange * solid.weight;
    const Vec3<double> slip = solid.velocity - u_before;
    const double spread =
        share_of_weight(cell.drag_square, cell.shared.drag) - solid.weight * dot(solid.velocity, solid.velocity);
    sum.slip += density * (held * (1 - 0.5 * held) * dot(slip, slip) + Operator::exchange * spread);

    const Vec3<double> u = u_before + (0.5 * held) * slip - Vec3<double>{mean_flow, 0, 0};
    sum.reynolds += density * square(u);
    sum.stored_momentum += height * (m.momentum.x - density * mean_flow);
    if (cell.shared.drag == 0) sum.free += {1, u_before.x};

    sum.see({of_block.origin[0] + x, of_block.origin[1] + y, of_block.origin[2] + z}, density,
            std::isfinite(density) && std::isfinite(dot(u, u)));
  }
  return sum;
}

}  // namespace

void add_row(FluidEnergy& sum, const FluidEnergy& row) {
  sum.see(row);
  sum.collisions += row.collisions;
  sum.slip += row.slip;
  sum.reynolds += row.reynolds;
  sum.stored_momentum += row.stored_momentum;
  sum.free += row.free;
}

template <class Stencil, class T>
RowEnergy<Stencil, T> row_energy_for(std::string_view collision, std::string_view coupling_operator) {
  RowEnergy<Stencil, T> found = nullptr;
  CollisionLaws::dispatch(collision, [&](auto c) {
    CouplingOperators::dispatch(coupling_operator, [&](auto o) {
      found = row_energy<Stencil, T, typename decltype(c)::type, typename decltype(o)::type>;
    });
  });
  return found;
}

template RowEnergy<D3Q19, double> row_energy_for<D3Q19, double>(std::string_view, std::string_view);
template RowEnergy<D3Q19, float> row_energy_for<D3Q19, float>(std::string_view, std::string_view);

}  // namespace stresslet
