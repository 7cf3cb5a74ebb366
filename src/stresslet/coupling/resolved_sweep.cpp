#include "stresslet/coupling/resolved_sweep.hpp"

#include <array>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);

/// The solid along one row, zero where there is none: sums over the images of alpha and of alpha us (shared_cells.hpp).
class SolidRow {
 public:
  explicit SolidRow(int nx) {
    for (auto& sum : sums_) sum.assign(std::size_t(nx + width), 0.0);
  }

  void add(const CoveredRun& run, const double* drags, const SphereImage& image, const ResolvedSphere& sphere) {
    const Pack lanes([](auto k) { return double(k); });
    const Vec3<double> arm{run.global[0] - image.centre.x, run.global[1] - image.centre.y,
                           run.global[2] - image.centre.z};
    // Along the row w x r changes with x alone: by (0, w_z, -w_y) a cell.
    const Vec3<double>& w = sphere.angular_velocity;
    const Vec3<double> first = rigid_velocity(sphere.velocity, w, arm);
    const Pack velocity_x = first.x + image.velocity_jump;
    for (int p = 0; p < run.packs * width; p += width) {
      const Pack drag = load(drags + p), along = lanes + Pack(double(p));
      const std::size_t x = std::size_t(run.x + p);
      add_to(0, x, drag);
      add_to(1, x, drag * velocity_x);
      add_to(2, x, drag * (Pack(first.y) + Pack(w.z) * along));
      add_to(3, x, drag * (Pack(first.z) - Pack(w.y) * along));
    }
  }
  void clear(const CoveredRun& run) {
    for (int p = 0; p < run.packs * width; p += width)
      for (auto& sum : sums_) store(&sum[std::size_t(run.x + p)], Pack(0.0));
  }
  [[gnu::always_inline]] bool is_covered(int x) const {
    return stdx::any_of(load(&sums_[0][std::size_t(x)]) > Pack(0.0));
  }
  [[gnu::always_inline]] CoveredCell<Pack> cell(int x) const {
    const auto at = [&](std::size_t k) { return load(&sums_[k][std::size_t(x)]); };
    return covered_cell(SharedDrag<Pack>{at(0), {at(1), at(2), at(3)}});
  }

 private:
  [[gnu::always_inline]] void add_to(std::size_t k, std::size_t x, const Pack& value) {
    store(&sums_[k][x], load(&sums_[k][x]) + value);
  }
  std::array<AlignedVector<double>, 4> sums_;
};

template <class Stencil, class Collision, class Forcing, class Operator>
void resolved_sweep(const Lattice<Stencil, double>& lattice, int block, const CoveredRuns& covered,
                    const std::vector<ResolvedSphere>& spheres, std::size_t first, std::size_t last) {
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const int nx = layout.size()[0], ny = layout.size()[1];
  SolidRow solid(nx);
  RowSweep<Stencil, double, Collision, Forcing> fluid(populations, lattice.arrangement, lattice.input);
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

template <class Stencil>
ResolvedSweep<Stencil> resolved_sweep_for(std::string_view collision, std::string_view coupling_operator, bool forced) {
  ResolvedSweep<Stencil> found = nullptr;
  CollisionLaws::dispatch(collision, [&](auto c) {
    CouplingOperators::dispatch(coupling_operator, [&](auto o) {
      using Collision = typename decltype(c)::type;
      using Operator = typename decltype(o)::type;
      found = forced ? resolved_sweep<Stencil, Collision, Guo, Operator>
                     : resolved_sweep<Stencil, Collision, NoForce, Operator>;
    });
  });
  return found;
}

template ResolvedSweep<D3Q19> resolved_sweep_for<D3Q19>(std::string_view, std::string_view, bool);

}  // namespace stresslet
