/// What resolved spheres cost: the step of a fluid with moving, free spheres over the step of the same fluid alone, in
/// one run. Every round measures each case once beside the plain fluid; a ratio is the median over rounds.
///
/// Beside the whole step stands what no implicit update of the spheres can be without, over the same plain step: the
/// sweep with the coupling in its covered cells, and density and momentum of the covered lines read once more before
/// it.
///
/// usage: bench_resolved [rounds, default 7] [threads, default 2]
/// The spheres sit on a cubic array, displaced at random, and move with random velocities.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <stdexcept>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"
#include "stresslet/exec/timer.hpp"
#include "stresslet/lattice/pack_in_place.hpp"

namespace stresslet {
namespace {

struct Case {
  int edge;
  double diameter;
  int spheres;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::vector<ResolvedSphere> scattered(const Case& c) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  int sites = 1;
  while (sites * sites * sites < c.spheres) ++sites;
  const double spacing = double(c.edge) / sites, play = spacing - c.diameter;
  std::vector<int> order(std::size_t(sites * sites * sites));
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = int(k);
  std::shuffle(order.begin(), order.end(), random);
  const auto draw = [&](double scale) {
    const double x = uniform(random), y = uniform(random), z = uniform(random);
    return scale * Vec3<double>{x, y, z};
  };
  std::vector<ResolvedSphere> spheres;
  for (int k = 0; k < c.spheres; ++k) {
    const int site = order[std::size_t(k)];
    const Vec3<double> at{(site % sites + 0.5) * spacing, (site / sites % sites + 0.5) * spacing,
                          (site / sites / sites + 0.5) * spacing};
    spheres.push_back({at + draw(play), 0.5 * c.diameter, draw(1e-3), draw(1e-4)});
  }
  return spheres;
}

class Resolved {
 public:
  Resolved(const Case& c, int threads) : team_(threads), fluid_(setup(c.edge), {}), spheres_(scattered(c)) {
    fluid_.initialise(team_, [](const Cells&) { return CellState{}; });
    const double mass = 4 * pi / 3 * std::pow(c.diameter / 2, 3);
    inertia_.assign(spheres_.size(), {mass, 0.1 * mass * c.diameter * c.diameter});
    step(2);
  }

  /// Of one step, and of its sweep.
  struct Times {
    double step, sweep;
  };
  Times seconds(int steps) {
    sweep_seconds_ = 0;
    const Timer timer;
    step(steps);
    return {timer.seconds() / steps, sweep_seconds_ / steps};
  }

  const CoveredRuns<double>& covered() const { return fluid_.covered(); }
  ThreadTeam& team() { return team_; }

 private:
  static FluidSetup setup(int edge) {
    FluidSetup setup;
    setup.grid.size = {edge, edge, edge};
    setup.collision = "TRT";
    setup.rates.relaxation_time = 1;
    setup.rates.magic_parameter = 1.0 / 12;
    return setup;
  }
  void step(int steps) {
    team_.run([&](Member& member) {
      for (int n = 0; n < steps; ++n) {
        fluid_.prepare(member, spheres_);
        if (member.rank() == 0) {
          std::vector<SphereLink> links;
          for (const PointFriction& friction : fluid_.friction()) links.push_back(link_of(friction));
          update_.settle(
              spheres_, inertia_, links, [&](std::size_t k) -> const auto& { return fluid_.exchange(k); });
        }
        member.barrier();
        const Timer timer;
        fluid_.sweep(member, spheres_);
        member.barrier();
        if (member.rank() == 0) {
          sweep_seconds_ += timer.seconds();
          for (ResolvedSphere& sphere : spheres_) sphere.centre += sphere.velocity;
        }
        member.barrier();
      }
    });
  }

  ThreadTeam team_;
  ResolvedFluidOf<double> fluid_;
  std::vector<ResolvedSphere> spheres_;
  std::vector<SphereInertia> inertia_;
  SphereUpdate update_;
  double sweep_seconds_ = 0;
};

/// The lines of populations that the runs of `covered` touch, each once, in the order of memory.
class CoveredLines {
 public:
  CoveredLines(int edge, const CoveredRuns<double>& covered) : populations_({edge, edge, edge}) {
    constexpr int line = cache_line / sizeof(double);
    const BlockLayout& layout = populations_.layout();
    // Written, or all pages that are read would be the one page of zeros.
    for (int i = 0; i < D3Q19::size; ++i) std::fill_n(populations_.slot(i), layout.stride(), 0.0);
    for (std::size_t row = 0; row < layout.rows(); ++row) {
      std::vector<bool> touched(std::size_t(edge / line + 1), false);
      const Range runs = covered.runs_of_row(0, row);
      for (std::size_t k = runs.begin; k < runs.end; ++k) {
        const CoveredRun& run = covered.runs()[k];
        for (int at = run.x / line; at <= (run.x + run.cells - 1) / line; ++at) touched[std::size_t(at)] = true;
      }
      const std::size_t start = layout.index(0, int(row % std::size_t(edge)), int(row / std::size_t(edge)));
      for (std::size_t at = 0; at < touched.size(); ++at)
        if (touched[at]) lines_.push_back(std::ptrdiff_t(start + at * line));
    }
  }

  /// Of reading all of them, as steps do that start from the one and the other arrangement in turn.
  double seconds(ThreadTeam& team, int times) {
    const Timer timer;
    team.run([&](Member& member) {
      const Range mine = member.share(lines_.size());
      for (int n = 0; n < times; ++n) {
        read(mine, n % 2 ? Arrangement::departing : Arrangement::arrived);
        member.barrier();
      }
    });
    return timer.seconds() / times;
  }

 private:
  using P = PackOf<double>;
  void read(const Range& lines, Arrangement arrangement) {
    constexpr std::size_t ahead = 4;
    const Sources<D3Q19, double> sources = sources_of(populations_, arrangement);
    P sum = 0;
    for (std::size_t k = lines.begin; k < lines.end; ++k) {
      if (k + ahead < lines.end) prefetch_line<D3Q19>(sources, lines_[k + ahead]);
      for (std::ptrdiff_t x = 0; x < std::ptrdiff_t(cache_line / sizeof(double)); x += std::ptrdiff_t(P::size())) {
        const auto moments = moments_of(PackInPlace<D3Q19, double>(sources, lines_[k] + x));
        sum += moments.density() + moments.momentum.x * moments.momentum.y * moments.momentum.z;
      }
    }
    // Read from populations at rest: the sum is that of ones, and the compiler cannot leave the reading out.
    if (lines.begin < lines.end && stdx::reduce(sum) < 1) throw std::logic_error("lines of a fluid at rest read wrong");
  }

  Populations<D3Q19, double> populations_;
  std::vector<std::ptrdiff_t> lines_;
};

void run(int rounds, int threads) {
  fmt::print("D3Q19, TRT, FP64, {} threads, {} rounds; the last three over the step of the fluid alone\n", threads,
             rounds);
  fmt::print("{:>6}{:>10}{:>9}{:>8}{:>12}{:>12}{:>12}{:>12}\n", "cells", "diameter", "spheres", "phi", "MLUPS", "step",
             "its sweep", "lines read");
  for (const int edge : {100, 200}) {
    Resolved plain({edge, 1, 0}, threads);
    const double diameter = edge / 10.0;
    for (const int spheres : {50, 200, 500}) {
      if (edge == 200 && spheres != 500) continue;
      Resolved resolved({edge, diameter, spheres}, threads);
      CoveredLines lines(edge, resolved.covered());
      std::vector<double> rates, step, sweep, read;
      for (int k = 0; k < rounds; ++k) {
        const int steps = edge == 100 ? 40 : 6;
        const double alone = plain.seconds(steps).step;
        const auto with = resolved.seconds(steps);
        rates.push_back(1e-6 * edge * edge * edge / with.step);
        step.push_back(with.step / alone);
        sweep.push_back(with.sweep / alone);
        read.push_back(lines.seconds(resolved.team(), steps) / alone);
      }
      fmt::print("{:>6}{:>10}{:>9}{:>8.3f}{:>12.1f}{:>12.2f}{:>12.2f}{:>12.2f}\n", edge, diameter, spheres,
                 spheres * pi / 6 * std::pow(diameter / edge, 3), median(rates), median(step), median(sweep),
                 median(read));
    }
  }
}

}  // namespace
}  // namespace stresslet

int main(int argc, char** argv) {
  stresslet::run(argc > 1 ? std::atoi(argv[1]) : 7, argc > 2 ? std::atoi(argv[2]) : 2);
}
