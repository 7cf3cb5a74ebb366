#include "stresslet/coupling/fluid_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stresslet/coupling/advected_moments.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/solid_row.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/pack_in_place.hpp"

namespace stresslet {

namespace {

/// sum n_i^2/w_i.
template <class Stencil, class R>
R weighted_square(const CellPopulations<Stencil, R>& f, const Equilibrium<Stencil, R>& eq) {
  R sum = as<R>(1 / Stencil::weight[0]) * (f.rest - eq.rest()) * (f.rest - eq.rest());
  unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) {
    constexpr int i = first_of_pair(k);
    const EvenOdd<R> target = eq.template pair<i>();
    const R even = f.pair[k].even - target.even, odd = f.pair[k].odd - target.odd;
    sum += as<R>(1 / (2 * Stencil::weight[i])) * (even * even + odd * odd);
  });
  return sum;
}

template <class Stencil, class T>
CellPopulations<Stencil, PackOf<T>> read_all(const PackInPlace<Stencil, T>& f) {
  CellPopulations<Stencil, PackOf<T>> all;
  all.rest = f.read_rest();
  unroll<Stencil::pairs>([&](auto k) __attribute__((always_inline)) { all.pair[k] = f.template read<k>(); });
  return all;
}

template <class P>
struct PackEnergy {
  P collisions{}, slip{}, stored_momentum{}, free_cells{}, free_velocity{};
  SymTensor3<P> reynolds{};
};

/// Solids of one row: with sum alpha us^2 besides.
template <class T>
struct RowOfSolids {
  SolidRow<T> solid;
  AlignedVector<T> drag_square;

  explicit RowOfSolids(int nx) : solid(nx), drag_square(std::size_t(nx + CoveredRuns<T>::width), T(0)) {}

  void add(const CoveredRuns<T>& covered, const Range& runs, const std::vector<ResolvedSphere>& spheres) {
    using P = PackOf<T>;
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      const SphereImage& image = covered.images()[std::size_t(run.image)];
      const ResolvedSphere& sphere = spheres[std::size_t(image.sphere)];
      solid.add(run, covered.drag(run), image, sphere);
      for_each_pack(run, covered.drag(run), image, sphere, [&](int p, const P& drag, const Vec3<P>& velocity) {
        T* const at = &drag_square[std::size_t(run.x + p)];
        store_unaligned(at, load_unaligned(at) + drag * dot(velocity, velocity));
      });
    }
  }
  void clear(const CoveredRuns<T>& covered, const Range& runs) {
    for (std::size_t k = runs.begin; k < runs.end; ++k) {
      const CoveredRun& run = covered.runs()[k];
      solid.clear(run);
      std::fill_n(&drag_square[std::size_t(run.x)], run.packs * CoveredRuns<T>::width, T(0));
    }
  }
};

template <class Stencil, class T, class Collision, class Operator>
FluidEnergy row_energy(const Lattice<Stencil, T>& lattice, int block, std::size_t row, const RowOfSolids<T>& solids,
                       double shear_rate) {
  using P = PackOf<T>;
  constexpr int width = CoveredRuns<T>::width;
  const auto& of_block = lattice.blocks[std::size_t(block)];
  const BlockLayout& layout = of_block.populations.layout();
  const int nx = layout.size()[0], ny = layout.size()[1], y = int(row) % ny, z = int(row) / ny;
  const Sources<Stencil, T> sources = sources_of(of_block.populations, lattice.arrangement);
  const std::ptrdiff_t start = std::ptrdiff_t(layout.index(0, y, z));
  const double height = of_block.origin[1] + y - 0.5 * (lattice.grid.size[1] - 1);
  const P odd_to_shear(T(lattice.input.rates.shear / lattice.input.rates.odd));
  const P mean_flow(T(shear_rate * height)), lanes([](auto k) { return T(k); });
  typename Collision::template Cell<Stencil, P> collision(lattice.input.rates);
  PackEnergy<P> sum;
  FluidEnergy found;
  for (int x = 0; x < nx; x += width) {
    if (x % int(cache_line / sizeof(T)) == 0) prefetch_line<Stencil>(sources, start + x, prefetch_distance);
    const CellPopulations<Stencil, P> read = read_all(PackInPlace<Stencil, T>(sources, start + x));
    const Moments<P> m = moments_of(read);
    const P density = m.density();
    const Vec3<P> u_before = m.momentum / density;
    const CellPopulations<Stencil, P> before = without_advected_moments(read, u_before, odd_to_shear);
    const Equilibrium<Stencil, P> eq(m.density_deviation, u_before);
    const P drag = solids.solid.drag(x);
    const CoveredCell<P> solid = solids.solid.cell(x);
    const auto inside = lanes + P(T(x)) < P(T(nx));
    const auto add = [&](P& to, const P& value) { to += select(inside, value, P(T(0))); };

    CellPopulations<Stencil, P> after = before;
    Operator::template collide<Collision, NoForce>(after, collision, BodyForce<P>{},
                                                   CoveredCell<P>{solid.weight, u_before});
    add(sum.collisions, weighted_square(before, eq) - weighted_square(after, eq));

    const P held = as<P>(Operator::exchange) * solid.weight;
    const Vec3<P> slip = solid.velocity - u_before;
    const P spread = share_of_weight(load(&solids.drag_square[std::size_t(x)]), drag) -
                     solid.weight * dot(solid.velocity, solid.velocity);
    add(sum.slip,
        density * (held * (as<P>(1) - as<P>(0.5) * held) * dot(slip, slip) + as<P>(Operator::exchange) * spread));

    const Vec3<P> u = u_before + (as<P>(0.5) * held) * slip - Vec3<P>{mean_flow, as<P>(0), as<P>(0)};
    const SymTensor3<P> flux = density * square(u);
    add(sum.reynolds.xx, flux.xx), add(sum.reynolds.yy, flux.yy), add(sum.reynolds.zz, flux.zz);
    add(sum.reynolds.xy, flux.xy), add(sum.reynolds.xz, flux.xz), add(sum.reynolds.yz, flux.yz);
    add(sum.stored_momentum, m.momentum.x - density * mean_flow);
    const P is_free = select(drag > as<P>(0), as<P>(0), as<P>(1));
    add(sum.free_cells, is_free), add(sum.free_velocity, is_free * u_before.x);

    const P speed_square = dot(u, u);
    const auto usual = density >= P(T(found.lowest_density)) && density <= P(T(found.highest_density)) &&
                       speed_square < P(std::numeric_limits<T>::max());
    if (stdx::none_of(inside && !usual)) continue;
    for (int k = 0; k < std::min(width, nx - x); ++k)
      found.see({of_block.origin[0] + x + k, of_block.origin[1] + y, of_block.origin[2] + z}, double(density[k]),
                std::isfinite(density[k]) && std::isfinite(speed_square[k]));
  }
  const auto total = [](const P& p) { return double(stdx::reduce(p)); };
  found.collisions = total(sum.collisions) / 6;
  found.slip = total(sum.slip);
  const SymTensor3<P>& r = sum.reynolds;
  found.reynolds = {total(r.xx), total(r.yy), total(r.zz), total(r.xy), total(r.xz), total(r.yz)};
  found.stored_momentum = height * total(sum.stored_momentum);
  found.free = {total(sum.free_cells), total(sum.free_velocity)};
  return found;
}

template <class Stencil, class T, class Collision, class Operator>
void energy_of_rows(const Lattice<Stencil, T>& lattice, int block, const CoveredRuns<T>& covered,
                    const std::vector<ResolvedSphere>& spheres, double shear_rate, const Range& rows,
                    FluidEnergy* by_row) {
  RowOfSolids<T> solids(lattice.blocks[std::size_t(block)].populations.layout().size()[0]);
  for (std::size_t row = rows.begin; row < rows.end; ++row) {
    const Range runs = covered.runs_of_row(block, row);
    solids.add(covered, runs, spheres);
    by_row[row] = row_energy<Stencil, T, Collision, Operator>(lattice, block, row, solids, shear_rate);
    solids.clear(covered, runs);
  }
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
      found = energy_of_rows<Stencil, T, typename decltype(c)::type, typename decltype(o)::type>;
    });
  });
  return found;
}

template RowEnergy<D3Q19, double> row_energy_for<D3Q19, double>(std::string_view, std::string_view);
template RowEnergy<D3Q19, float> row_energy_for<D3Q19, float>(std::string_view, std::string_view);

}  // namespace stresslet
