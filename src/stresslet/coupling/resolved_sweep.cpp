#include "stresslet/coupling/resolved_sweep.hpp"

#include <array>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

namespace {

/// The solid along one row, zero where there is none: sums over the images of alpha and of alpha us (shared_cells.hpp).
template <class T>
class SolidRow {
 public:
  using P = PackOf<T>;
  static constexpr int width = CoveredRuns<T>::width;

  explicit SolidRow(int nx) {
    for (auto& sum : sums_) sum.assign(std::size_t(nx + width), T(0));
  }

  void add(const CoveredRun& run, const T* drags, const SphereImage& image, const ResolvedSphere& sphere) {
    const P lanes([](auto k) { return T(k); });
    const Vec3<double> arm{run.global[0] - image.centre.x, run.global[1] - image.centre.y,
                           run.global[2] - image.centre.z};
    // Along the row w x r changes with x alone: by (0, w_z, -w_y) a cell.
    const Vec3<double>& w = sphere.angular_velocity;
    const Vec3<double> first = rigid_velocity(sphere.velocity, w, arm);
    const P velocity_x(T(first.x + image.velocity_jump));
    for (int p = 0; p < run.packs * width; p += width) {
      const P drag = load(drags + p), along = lanes + P(T(p));
      const std::size_t x = std::size_t(run.x + p);
      add_to(0, x, drag);
      add_to(1, x, drag * velocity_x);
      add_to(2, x, drag * (P(T(first.y)) + P(T(w.z)) * along));
      add_to(3, x, drag * (P(T(first.z)) - P(T(w.y)) * along));
    }
  }
  void clear(const CoveredRun& run) {
    for (int p = 0; p < run.packs * width; p += width)
      for (auto& sum : sums_) store(&sum[std::size_t(run.x + p)], P(T(0)));
  }
  [[gnu::always_inline]] bool is_covered(int x) const {
    return stdx::any_of(load(&sums_[0][std::size_t(x)]) > P(T(0)));
  }
  [[gnu::always_inline]] CoveredCell<P> cell(int x) const {
    const auto at = [&](std::size_t k) { return load(&sums_[k][std::size_t(x)]); };
    return covered_cell(SharedDrag<P>{at(0), {at(1), at(2), at(3)}});
  }

 private:
  [[gnu::always_inline]] void add_to(std::size_t k, std::size_t x, const P& value) {
    store(&sums_[k][x], load(&sums_[k][x]) + value);
  }
  std::array<AlignedVector<T>, 4> sums_;
};

template <class Stencil, class T, class Collision, class Forcing, class Operator>
void resolved_sweep(const Lattice<Stencil, T>& lattice, int block, const CoveredRuns<T>& covered,
                    const std::vector<ResolvedSphere>& spheres, std::size_t first, std::size_t last) {
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
    fluid.start(layout.index(0, int(row) % ny, int(row) / ny));
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
