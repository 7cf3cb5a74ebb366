/// Flow along a square duct of side 1, driven by a uniform force density, unit viscosity and force:
///   u = (4/pi^3) sum_{n odd} (-1)^{(n-1)/2} n^-3 [1 - cosh(n pi z)/cosh(n pi/2)] cos(n pi y),   |y|, |z| <= 1/2,
///   mean = (1/12) [1 - (192/pi^5) sum_{n odd} n^-5 tanh(n pi/2)]
/// (White, Viscous Fluid Flow, eqs. 3-48 and 3-49). Greatest over mean velocity 2.0963; Darcy friction factor times
/// Reynolds number of the hydraulic diameter 2 / mean = 56.91.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

constexpr int last_term = 801;

/// Each term carries its decay towards the wall as exponentials, which do not overflow.
double exact_velocity(double y, double z) {
  double sum = 0;
  for (int n = 1; n <= last_term; n += 2) {
    const double a = n * pi, sign = n % 4 == 1 ? 1 : -1;
    const double ratio = (std::exp(a * (std::abs(z) - 0.5)) + std::exp(-a * (std::abs(z) + 0.5))) / (1 + std::exp(-a));
    sum += sign * (1 - ratio) * std::cos(a * y) / (double(n) * n * n);
  }
  return 4 / (pi * pi * pi) * sum;
}

double exact_mean() {
  double sum = 0;
  for (int n = 1; n <= last_term; n += 2) sum += std::tanh(n * pi / 2) / std::pow(n, 5);
  return (1 - 192 / std::pow(pi, 5) * sum) / 12;
}

struct Found {
  double peak_over_mean, friction;  // u_max / u_mean, f Re
  double error;                     // relative L2 error of the velocity
  std::vector<double> centre_line;  // velocity, over its exact greatest value
};

Found measure(Trial& trial, const std::string& collision, double relaxation_time, int cells) {
  const double viscosity = kinematic_viscosity_lu(relaxation_time);
  const double peak_speed = 0.01, force = peak_speed * viscosity / (exact_velocity(0, 0) * cells * cells);
  FluidSetup setup = periodic_box("D3Q19", {cells, cells, 1}, collision, relaxation_time);
  setup.forcing = "guo";
  add_walls(setup, 0);
  add_walls(setup, 1);
  Flow flow(trial, setup, fmt::format("L5, {} at {} cells", collision, cells));
  flow.fluid().set_force_density({0, 0, force});
  flow.rest();
  const double time = cells * cells / (2 * pi * pi * viscosity);
  flow.advance_to_steady(1e-9, int(time), int(40 * time) + 1000);

  const std::vector<double> velocity = picked(flow.states(), [](const CellState& s) { return s.velocity.z; });
  const double unit = force * cells * cells / viscosity;
  std::vector<double> exact;
  double mean = 0;
  for (int y = 0; y < cells; ++y)
    for (int x = 0; x < cells; ++x) {
      exact.push_back(unit * exact_velocity((x + 0.5) / cells - 0.5, (y + 0.5) / cells - 0.5));
      mean += velocity[std::size_t(x + cells * y)] / (cells * cells);
    }
  const std::size_t middle = std::size_t(cells / 2);
  Found found{
      velocity[middle * std::size_t(cells + 1)] / mean, 2 * unit / mean, relative_l2_error(velocity, exact), {}};
  for (std::size_t x = 0; x < std::size_t(cells); ++x)
    found.centre_line.push_back(velocity[x + std::size_t(cells) * middle] / (unit * exact_velocity(0, 0)));
  return found;
}

}  // namespace

void square_duct(Trial& trial) {
  const std::vector<int> sizes = trial.choose<std::vector<int>>({9, 27, 81}, {5, 15, 45});
  trial.parameter("cells a side", double(sizes.back()));
  trial.parameter("relaxation time", 1.5);
  trial.parameter("magic parameter", 3.0 / 16);

  const double mean = exact_mean(), ratio = exact_velocity(0, 0) / mean;
  const std::string source = "series, White 2006 eq. 3-48";
  trial.row("series: u_max / u_mean", ratio, {2.0963, "White 2006"}, absolute(5e-5));
  trial.row("series: f Re", 2 / mean, {56.91, "White 2006"}, absolute(5e-3));

  std::vector<double> grid, error, peak, friction;
  Found finest;
  for (const int cells : sizes) {
    finest = measure(trial, "TRT", 1.5, cells);
    grid.push_back(cells);
    error.push_back(finest.error);
    peak.push_back(finest.peak_over_mean - ratio);
    friction.push_back(finest.friction - 2 / mean);
  }
  const double bound = trial.choose(5e-4, 2e-3);
  trial.row("TRT: u_max / u_mean", finest.peak_over_mean, {ratio, source}, relative(bound));
  trial.row("TRT: f Re", finest.friction, {2 / mean, source}, relative(bound));
  trial.row("TRT: velocity, relative L2 error", finest.error, {0, source}, absolute(bound));
  trial.order_rows("velocity", sizes, error, 2, 1.8, trial.choose(2.2, 2.35));
  trial.order_rows("u_max / u_mean", sizes, peak, 2, 1.8, trial.choose(2.2, 2.35));
  trial.order_rows("f Re", sizes, friction, 2, 1.8, trial.choose(2.2, 2.35));
  for (const char* collision : {"BGK", "MRT"}) {
    // With BGK this relaxation time makes Lambda 3/16.
    const Found found = measure(trial, collision, 0.5 + std::sqrt(3) / 4, sizes[1]);
    const double coarse = trial.choose(2e-3, 8e-3);
    trial.row(fmt::format("{}, {} cells: u_max / u_mean", collision, sizes[1]), found.peak_over_mean, {ratio, source},
              relative(coarse));
    trial.row(fmt::format("{}, {} cells: f Re", collision, sizes[1]), found.friction, {2 / mean, source},
              relative(coarse));
  }
  Table profile{"centre_line", {{"y", "side", ""}, {"velocity", "u_max", ""}, {"exact", "u_max", ""}}, {{}, {}, {}}};
  for (int c = 0; c < sizes.back(); ++c) {
    const double y = (c + 0.5) / sizes.back() - 0.5;
    profile.values[0].push_back(y);
    profile.values[1].push_back(finest.centre_line[std::size_t(c)]);
    profile.values[2].push_back(exact_velocity(y, 0) / exact_velocity(0, 0));
  }
  trial.table(std::move(profile));
  trial.table({"convergence", {{"cells", "", ""}, {"velocity_error", "", ""}}, {grid, error}});
}

}  // namespace stresslet::validation
