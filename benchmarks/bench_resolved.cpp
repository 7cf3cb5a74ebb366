/// What resolved spheres cost: the step of a fluid with moving, free spheres over the step of the same fluid alone, in
/// one run. Every round measures each case once beside the plain fluid; a ratio is the median over rounds.
///
/// usage: bench_resolved [rounds, default 7] [threads, default 2]
/// The spheres sit on a cubic array, displaced at random, and move with random velocities.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"
#include "stresslet/exec/timer.hpp"

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

  double seconds(int steps) {
    const Timer timer;
    step(steps);
    return timer.seconds() / steps;
  }

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
        fluid_.sweep(member, spheres_);
        if (member.rank() == 0)
          for (ResolvedSphere& sphere : spheres_) sphere.centre += sphere.velocity;
        member.barrier();
      }
    });
  }

  ThreadTeam team_;
  ResolvedFluidOf<double> fluid_;
  std::vector<ResolvedSphere> spheres_;
  std::vector<SphereInertia> inertia_;
  SphereUpdate update_;
};

void run(int rounds, int threads) {
  fmt::print("D3Q19, TRT, FP64, {} threads, {} rounds\n{:>6}{:>10}{:>9}{:>8}{:>12}{:>16}\n", threads, rounds, "cells",
             "diameter", "spheres", "phi", "MLUPS", "over fluid alone");
  for (const int edge : {100, 200}) {
    Resolved plain({edge, 1, 0}, threads);
    const double diameter = edge / 10.0;
    for (const int spheres : {50, 200, 500}) {
      if (edge == 200 && spheres != 500) continue;
      Resolved resolved({edge, diameter, spheres}, threads);
      std::vector<double> ratios, rates;
      for (int k = 0; k < rounds; ++k) {
        const int steps = edge == 100 ? 40 : 6;
        const double alone = plain.seconds(steps), with = resolved.seconds(steps);
        ratios.push_back(with / alone);
        rates.push_back(1e-6 * edge * edge * edge / with);
      }
      fmt::print("{:>6}{:>10}{:>9}{:>8.3f}{:>12.1f}{:>16.3f}\n", edge, diameter, spheres,
                 spheres * pi / 6 * std::pow(diameter / edge, 3), median(rates), median(ratios));
    }
  }
}

}  // namespace
}  // namespace stresslet

int main(int argc, char** argv) {
  stresslet::run(argc > 1 ? std::atoi(argv[1]) : 7, argc > 2 ? std::atoi(argv[2]) : 2);
}
