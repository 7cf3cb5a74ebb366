#include "stresslet/coupling/covered_cells.hpp"

#include "stresslet/coupling/shared_cells.hpp"

namespace stresslet {

namespace {

double sum_of_drags(const Lattice<D3Q19, double>& lattice, const CoveredRuns<double>& covered, const CoveredRun& run,
                    int x) {
  double sum = 0;
  const int ny = lattice.blocks[std::size_t(run.block)].populations.layout().size()[1];
  const Range row = covered.runs_of_row(run.block, std::size_t(run.y + ny * run.z));
  for (std::size_t k = row.begin; k < row.end; ++k) {
    const CoveredRun& other = covered.runs()[k];
    const int place = x - other.x;
    if (place >= 0 && place < other.packs * CoveredRuns<double>::width) sum += covered.drag(other)[place];
  }
  return sum;
}

}  // namespace

void for_each_covered_cell(const Lattice<D3Q19, double>& lattice, const CoveredRuns<double>& covered,
                           const std::function<void(const ReportedCell&)>& visit) {
  for (const CoveredRun& run : covered.runs()) {
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    const auto& populations = lattice.blocks[std::size_t(run.block)].populations;
    const BlockLayout& layout = populations.layout();
    for (int x = run.cells.begin; x < run.cells.end; ++x) {
      const int place = x - run.global[0];
      const double drag = covered.drag(run)[place];
      if (drag == 0) continue;
      const auto f = incoming(populations, lattice.arrangement, layout.index(run.x + place, run.y, run.z));
      const Moments<double> m = moments_of(f);
      const double density = m.density();
      const Vec3<double> velocity = (m.momentum + 0.5 * lattice.input.force_density) / density;
      visit({std::size_t(image.sphere),
             {x, run.global[1], run.global[2]},
             {x - image.centre.x, run.global[1] - image.centre.y, run.global[2] - image.centre.z},
             drag,
             share_of_weight(drag, sum_of_drags(lattice, covered, run, run.x + place)),
             density,
             velocity - Vec3<double>{image.velocity_jump, 0, 0}});
    }
  }
}

}  // namespace stresslet
