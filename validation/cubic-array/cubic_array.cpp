/// Simple cubic arrays with the default scheme: drag K against Zick & Homsy, J. Fluid Mech. 115 (1982) 13, and
/// effective viscosity of the aligned lattice in shear against Nunan & Keller, J. Fluid Mech. 142 (1984) 269, both
/// recomputed from the Stokes equations. Results must not depend on the position on the grid nor on the relaxation
/// time.
#include <algorithm>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "validation/harness/periodic_array.hpp"

namespace stresslet::validation {

namespace {

/// At d/L = 5/8, solid fraction 0.128: between the values of the table at d/L = 0.6 and 0.7 (good to 1e-5).
constexpr double exact_drag = 4.36973;

/// Places relative to the middle of the box, in cells: on a node, on a corner, and between.
const Vec3<double> places[] = {{0, 0, 0}, {0.5, 0.5, 0.5}, {0.5, 0, 0}, {0.2, 0.7, 0.4}, {0.37, 0.13, 0.81}};

Vec3<double> place(int edge, std::size_t k) {
  const double middle = edge / 2;
  return Vec3<double>{middle, middle, middle} + places[k];
}

}  // namespace

void cubic_array(Trial& trial) {
  const std::vector<double> times = trial.choose<std::vector<double>>({0.55, 0.7, 1, 1.5, 2}, {1, 2});
  const char* source = "Zick & Homsy 1982, recomputed";

  double reference = 0;
  for (const double tau : times) {
    const double K = drag_of_cubic_array(trial, default_scheme(tau), 16, 5, place(16, 3));
    trial.row(fmt::format("K, N = 10, tau {}", tau), K, {exact_drag, source}, relative(0.015));
    if (tau == 1) reference = K;
  }
  for (const double tau : times)
    if (tau != 1)
      trial.row(fmt::format("K at tau {} against tau 1", tau),
                drag_of_cubic_array(trial, default_scheme(tau), 16, 5, place(16, 3)), {reference, "same scheme"},
                relative(0.003));
  for (const auto& [edge, spread] : {std::pair{16, 0.003}, {10, 0.005}}) {
    double lowest = 1e300, highest = 0;
    for (std::size_t k = 0; k < std::size(places); ++k) {
      const double K = drag_of_cubic_array(trial, default_scheme(2), edge, edge * 5 / 16.0, place(edge, k));
      trial.row(
          fmt::format("K, N = {}, {} {} {} off the middle", edge * 5 / 8.0, places[k].x, places[k].y, places[k].z), K,
          {exact_drag, source}, relative(0.015));
      lowest = std::min(lowest, K), highest = std::max(highest, K);
    }
    trial.row(fmt::format("K, N = {}, highest over lowest of the places, less 1", edge * 5 / 8.0), highest / lowest - 1,
              {0, "no grid"}, absolute(spread));
  }

  std::vector<int> sizes;
  std::vector<double> errors;
  for (const int edge : trial.choose<std::vector<int>>({10, 13, 16, 24, 32, 48}, {10, 16})) {
    const double K = drag_of_cubic_array(trial, default_scheme(1), edge, edge * 5 / 16.0, place(edge, 3));
    sizes.push_back(edge);
    errors.push_back(K / exact_drag - 1);
    if (edge >= 32) trial.row(fmt::format("K, N = {}", edge * 5 / 8), K, {exact_drag, source}, relative(0.007));
  }
  Table resolution{"resolution", {{"L", "cells", ""}, {"error", "", "K/K_exact - 1"}}, {{}, {}}};
  resolution.values[0].assign(sizes.begin(), sizes.end());
  resolution.values[1] = errors;
  trial.table(resolution);
  if (trial.quick()) return;

  const std::pair<double, double> viscosities[] = {{0.027, 0.06633}, {0.1, 0.24142}, {0.2, 0.49709}, {0.3, 0.81783}};
  for (const auto& [fraction, beta] : viscosities) {
    const int edge = int(std::lround(10 * std::cbrt(pi / (6 * fraction))));
    const double radius = std::cbrt(fraction * std::pow(edge, 3) * 3 / (4 * pi));
    const ArrayRheology r = sheared_cubic_lattice(trial, default_scheme(1), edge, radius, 0, place(edge, 3));
    trial.row(fmt::format("beta at solid fraction {}, N = {:.2f}", fraction, 2 * radius), r.viscosity - 1,
              {beta, "Nunan & Keller 1984, recomputed"}, relative(0.015));
  }
}

}  // namespace stresslet::validation
