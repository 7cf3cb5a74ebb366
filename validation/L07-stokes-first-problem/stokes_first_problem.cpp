/// A plate in a fluid at rest is set moving with U along itself at time 0 (Stokes, 1851):
///   u = U erfc(y / (2 sqrt(nu t))),   du/dy = -U e^{-y^2/(4 nu t)} / sqrt(pi nu t).
/// The far wall, at rest, lies where u has fallen below 1e-7 U. Diffusive scaling: t ~ N^2 at a fixed relaxation time.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

constexpr double speed = 0.01;

struct Found {
  double velocity_error, strain_error;  // relative L2
  double wall_shear;                    // velocity gradient at the first cell, over the exact one there
  std::vector<double> position, velocity, exact;
};

/// `cells` to the far wall; measured when 2 sqrt(nu t) is an eighth of that.
Found measure(Trial& trial, const std::string& collision, double relaxation_time, int cells) {
  FluidSetup setup = periodic_box("D2Q9", {cells, 1, 1}, collision, relaxation_time);
  add_walls(setup, 0, {0, speed, 0});
  Flow flow(trial, setup, fmt::format("L7, {} at {} cells", collision, cells));
  flow.rest();
  const double viscosity = kinematic_viscosity_lu(relaxation_time);
  const int steps = int(std::lround(cells * cells / (16.0 * 16 * viscosity)));
  flow.advance(steps);
  const double depth = 2 * std::sqrt(viscosity * steps);

  const std::vector<CellState> states = flow.states();
  Found found;
  std::vector<double> strain, exact_strain;
  for (int c = 0; c < cells; ++c) {
    const double y = c + 0.5;
    found.position.push_back(y / depth);
    found.velocity.push_back(states[std::size_t(c)].velocity.y / speed);
    found.exact.push_back(std::erfc(y / depth));
    strain.push_back(states[std::size_t(c)].strain_rate.xy);
    exact_strain.push_back(-speed / (std::sqrt(pi) * depth) * std::exp(-y * y / (depth * depth)));
  }
  found.velocity_error = relative_l2_error(found.velocity, found.exact);
  found.strain_error = relative_l2_error(strain, exact_strain);
  found.wall_shear = strain[0] / exact_strain[0];
  return found;
}

}  // namespace

void stokes_first_problem(Trial& trial) {
  const std::vector<int> sizes = trial.choose<std::vector<int>>({64, 128, 256}, {32, 64, 128});
  const double relaxation_time = 0.8, bound = trial.choose(1e-3, 4e-3);
  trial.parameter("cells to the far wall", double(sizes.back()));
  trial.parameter("2 sqrt(nu t), cells", sizes.back() / 8.0);
  trial.parameter("relaxation time", relaxation_time);
  const std::string source = "erfc, Stokes 1851";

  std::vector<double> velocity, strain;
  for (const int cells : sizes) {
    Found found = measure(trial, "TRT", relaxation_time, cells);
    velocity.push_back(found.velocity_error);
    strain.push_back(found.strain_error);
    if (cells == sizes.back())
      trial.table({"profile",
                   {{"y", "2 sqrt(nu t)", ""}, {"velocity", "U", ""}, {"exact", "U", ""}},
                   {found.position, found.velocity, found.exact}});
  }
  trial.order_rows("velocity", sizes, velocity, 2, 1.9, 2.1);
  trial.order_rows("strain rate", sizes, strain, 2, 1.9, 2.1);
  const auto rows = [&](const std::string& collision, double tau) {
    const Found found = measure(trial, collision, tau, sizes.back());
    const std::string name = fmt::format("{}, tau {}", collision, tau);
    trial.row(name + ": velocity, relative L2 error", found.velocity_error, {0, source}, absolute(bound));
    trial.row(name + ": strain rate, relative L2 error", found.strain_error, {0, source}, absolute(bound));
    trial.row(name + ": strain rate next to the plate over exact", found.wall_shear, {1, source}, relative(bound));
  };
  for (const std::string& collision : CollisionLaws::names()) rows(collision, relaxation_time);
  for (const double tau : {0.55, 1.5}) rows("TRT", tau);
}

}  // namespace stresslet::validation
