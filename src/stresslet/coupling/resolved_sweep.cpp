#include "stresslet/coupling/resolved_sweep.hpp"

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/shared_cells.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/sweep_kernel.hpp"

namespace stresslet {

namespace {

constexpr int width = int(pack_width);

/// The solid along one row: sums over the solids of every pack, and which packs have any.
class SolidRow {
 public:
  explicit SolidRow(int nx) : packs_(std::size_t((nx + width - 1) / width)), covered_(packs_.size(), 0) {}

  void add(const CoveredRun& run, const double* drag, const SphereImage& image, const ResolvedSphere& sphere) {
    const Pack lanes([](auto k) { return double(k); });
    const Vec3<double> arm{run.global[0] - image.centre.x, run.global[1] - image.centre.y,
                           run.global[2] - image.centre.z};
    // Along the row w x r changes with x alone: by (0, w_z, -w_y) a cell.
    const Vec3<double>& w = sphere.angular_velocity;
    const Vec3<double> first = rigid_velocity(sphere.velocity, w, arm);
    for (int p = 0; p < run.packs; ++p) {
      const Pack along = lanes + Pack(double(p * width));
      const std::size_t place = std::size_t(run.x / width + p);
      if (!covered_[place]) packs_[place] = {}, used_.push_back(place);
      covered_[place] = 1;
      packs_[place].add(load(drag + p * width),
                        Vec3<Pack>{Pack(first.x + image.velocity_jump), Pack(first.y) + Pack(w.z) * along,
                                   Pack(first.z) - Pack(w.y) * along});
    }
  }
  void clear() {
    for (const std::size_t place : used_) covered_[place] = 0;
    used_.clear();
  }
  bool is_covered(int pack) const { return covered_[std::size_t(pack)]; }
  CoveredCell<Pack> cell(int pack) const { return covered_cell(packs_[std::size_t(pack)]); }

 private:
  std::vector<SharedDrag<Pack>, AlignedAllocator<SharedDrag<Pack>>> packs_;
  std::vector<std::uint8_t> covered_;
  std::vector<std::size_t> used_;
};

template <class Stencil, class Collision, class Operator>
void resolved_sweep(const Lattice<Stencil, double>& lattice, int block, const CoveredRuns& covered,
                    const std::vector<ResolvedSphere>& spheres, std::size_t first, std::size_t last) {
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const int nx = layout.size()[0], ny = layout.size()[1];
  SolidRow solid(nx);
  RowSweep<Stencil, double, Collision, Guo> fluid(lattice.input);
  for (std::size_t row = first; row < last; ++row) {
    const auto [begin, end] = covered.runs_of_row(block, row);
    for (const std::int32_t* k = begin; k != end; ++k) {
      const CoveredRun& run = covered.runs()[std::size_t(*k)];
      const SphereImage& image = covered.images()[std::size_t(run.image)];
      solid.add(run, covered.drag(run), image, spheres[std::size_t(image.sphere)]);
    }
    fluid.start(populations, lattice.arrangement, layout.index(0, int(row) % ny, int(row) / ny));
    for (int p = 0, x = 0; x < nx; ++p, x += width) {
      if (p % 2 == 0) fluid.prefetch(x);
      const auto collide_solid = [&](auto& f, auto& rates, const auto& force) {
        Operator::template collide<Collision, Guo>(f, rates, force, solid.cell(p));
      };
      if (solid.is_covered(p))
        fluid.step(x, std::min(width, nx - x), collide_solid);
      else
        fluid.step(x, std::min(width, nx - x));
    }
    solid.clear();
  }
}

}  // namespace

template <class Stencil>
ResolvedSweep<Stencil> resolved_sweep_for(std::string_view collision, std::string_view coupling_operator) {
  ResolvedSweep<Stencil> found = nullptr;
  CollisionLaws::dispatch(collision, [&](auto c) {
    CouplingOperators::dispatch(coupling_operator, [&](auto o) {
      found = resolved_sweep<Stencil, typename decltype(c)::type, typename decltype(o)::type>;
    });
  });
  return found;
}

template ResolvedSweep<D3Q19> resolved_sweep_for<D3Q19>(std::string_view, std::string_view);

}  // namespace stresslet
