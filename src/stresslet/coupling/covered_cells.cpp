#include "stresslet/coupling/covered_cells.hpp"

#include "stresslet/coupling/shared_cells.hpp"

namespace stresslet {

namespace {

double sum_of_drags(const CoveredRuns<double>& covered, const Range& row, int x) {
  double sum = 0;
  for (std::size_t k = row.begin; k < row.end; ++k) {
    const CoveredRun& other = covered.runs()[k];
    const int place = x - other.x;
    if (place >= 0 && place < other.cells) sum += covered.drag(other)[place];
  }
  return sum;
}

void visit_row(const Lattice<D3Q19, double>& lattice, const CoveredRuns<double>& covered, int block, std::size_t row,
               const std::function<void(const ReportedCell&)>& visit) {
  const auto& populations = lattice.blocks[std::size_t(block)].populations;
  const BlockLayout& layout = populations.layout();
  const std::size_t ny = std::size_t(layout.size()[1]);
  const std::size_t start = layout.index(0, int(row % ny), int(row / ny));
  const Range runs = covered.runs_of_row(block, row);
  for (std::size_t k = runs.begin; k < runs.end; ++k) {
    const CoveredRun& run = covered.runs()[k];
    const SphereImage& image = covered.images()[std::size_t(run.image)];
    for (int place = 0; place < run.cells; ++place) {
      const double drag = covered.drag(run)[place];
      if (drag == 0) continue;
      const int x = run.x + place;
      const auto f = incoming(populations, lattice.arrangement, start + std::size_t(x));
      const Moments<double> m = moments_of(f);
      const double density = m.density();
      const Vec3<double> velocity = (m.momentum + 0.5 * lattice.input.force_density) / density;
      visit({std::size_t(image.sphere),
             {run.global_x + place, run.global_y, run.global_z},
             run.arm(image.centre) + Vec3<double>{double(place), 0, 0},
             drag,
             share_of_weight(drag, sum_of_drags(covered, runs, x)),
             density,
             velocity - Vec3<double>{image.velocity_jump, 0, 0}});
    }
  }
}

}  // namespace

void for_each_covered_cell(const Lattice<D3Q19, double>& lattice, const CoveredRuns<double>& covered,
                           const std::function<void(const ReportedCell&)>& visit) {
  for (std::size_t block = 0; block < lattice.blocks.size(); ++block)
    for (std::size_t row = 0; row < lattice.blocks[block].populations.layout().rows(); ++row)
      visit_row(lattice, covered, int(block), row, visit);
}

}  // namespace stresslet
