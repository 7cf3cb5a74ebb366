/// A box of height L between sheared (Lees-Edwards) faces, image velocity gdot L. Started at rest,
///   u(y, t) = gdot [y - sum_n 2 (-1)^{n+1}/k_n sin(k_n y) e^{-nu k_n^2 t}],   k_n = 2 pi n / L,
/// y from the middle of the box; any start without mean flow across y relaxes to u = gdot y plus a constant. Momentum
/// along y and z stays to round-off; that along x changes by -U per mass that crosses upwards, U the image velocity,
/// and by nothing else. The bits must not depend on the blocks. The linear profile alone would not notice a wrong
/// boundary; see L9.
#include <algorithm>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

constexpr double relaxation_time = 0.9;

FluidSetup sheared_box(const Cells& size, const std::string& collision, double velocity) {
  FluidSetup setup = periodic_box("D3Q19", size, collision, relaxation_time);
  setup.grid.closure[1] = Closure::sheared;
  setup.shear_velocity_lu = velocity;
  return setup;
}

/// Relative L2 error of the profile at nu t = L^2 / 40, started at rest.
double transient_error(Trial& trial, int cells) {
  const double velocity = 1.6 / cells, viscosity = kinematic_viscosity_lu(relaxation_time);
  Flow flow(trial, sheared_box({4, cells, 1}, "TRT", velocity), fmt::format("L10 at {} cells", cells));
  flow.rest();
  const int steps = int(std::lround(cells * cells / (40 * viscosity)));
  flow.advance(steps);
  const std::vector<CellState> states = flow.states();
  std::vector<double> found, exact;
  for (int c = 0; c < cells; ++c) {
    const double y = c + 0.5 - 0.5 * cells;
    double sum = y;
    for (int n = 1; n < 40; ++n) {
      const double k = 2 * pi * n / cells;
      sum -= (n % 2 ? 2 : -2) / k * std::sin(k * y) * std::exp(-viscosity * k * k * steps);
    }
    exact.push_back(velocity / cells * sum);
    found.push_back(states[std::size_t(4 * c)].velocity.x);
  }
  return relative_l2_error(found, exact);
}

/// A start without symmetry, and with sound.
CellState lively_state(const Cells& c, const Cells& size) {
  const double x = 2 * pi * c[0] / size[0], y = 2 * pi * c[1] / size[1], z = 2 * pi * c[2] / size[2];
  CellState s;
  s.velocity = {0.01 + 0.02 * std::sin(x + 2 * y + z), -0.01 * std::cos(x - y), 0.01 * std::sin(y + z) - 0.004};
  s.density = 1 + 0.01 * std::cos(2 * x + y - z);
  return s;
}

/// sum rho y, less that of the rest state; y = 0 in the lowest cells.
double mass_moment(Flow& flow) {
  const std::vector<CellState> states = flow.states();
  double sum = 0;
  for (std::size_t k = 0; k < states.size(); ++k)
    sum += (states[k].density - 1) * double(int(k) / flow.size()[0] % flow.size()[1]);
  return sum;
}

}  // namespace

void sheared_profile(Trial& trial) {
  const Cells size{16, 16, 4};
  const double velocity = 0.05, viscosity = kinematic_viscosity_lu(relaxation_time);
  trial.parameter("cells", fmt::format("{} x {} x {}", size[0], size[1], size[2]));
  trial.parameter("image velocity, lattice units", velocity);
  trial.parameter("relaxation time", relaxation_time);

  const std::vector<int> sizes = trial.choose<std::vector<int>>({16, 32, 64}, {8, 16, 32});
  std::vector<double> errors;
  for (const int cells : sizes) errors.push_back(transient_error(trial, cells));
  trial.row(fmt::format("from rest, {} cells: profile at nu t = L^2/40, relative L2 error", sizes.back()),
            errors.back(), {0, "Fourier series"}, absolute(trial.choose(1e-3, 4e-3)));
  trial.order_rows("profile", sizes, errors, 2, 1.9, 2.15);

  const int relaxed = int(36 * size[1] * size[1] / (4 * pi * pi * viscosity)), early = 100;
  const double cells = double(size[0] * size[1] * size[2]);
  std::vector<double> bits;
  for (const std::string& collision : CollisionLaws::names()) {
    Flow flow(trial, sheared_box(size, collision, velocity), "L10, " + collision);
    flow.initialise([&](const Cells& c) { return lively_state(c, size); });
    const Fluid::Totals start = flow.fluid().totals(trial.team());
    double crossed = 0, moment = mass_moment(flow);
    for (int step = 0; step < early; ++step) {
      // sum rho y changes by sum rho u_y a step, less the height times the mass that crosses.
      const double expected = moment + flow.fluid().totals(trial.team()).momentum.y;
      flow.advance(1);
      moment = mass_moment(flow);
      crossed += (expected - moment) / size[1];
    }
    if (collision == Trt::name) bits = flow.fluid().populations(trial.team());
    const Fluid::Totals now = flow.fluid().totals(trial.team());
    const Vec3<double> change = now.momentum - start.momentum + Vec3<double>{velocity * crossed, 0, 0};
    trial.row(collision + ": drift of momentum a step, net of what mass carries across", norm(change) / early,
              {0, "conservation"}, absolute(1e-12));
    trial.row(collision + ": drift of mass a step", std::abs(now.mass_deviation - start.mass_deviation) / early,
              {0, "conservation"}, absolute(1e-12));

    flow.advance(relaxed - early);
    const std::vector<CellState> states = flow.states();
    Vec3<double> mean{};
    for (const CellState& s : states) mean += s.velocity / cells;
    double worst = 0;
    for (std::size_t k = 0; k < states.size(); ++k) {
      const double y = double(int(k) / size[0] % size[1]) + 0.5 - 0.5 * size[1];
      const double error = norm(states[k].velocity - mean - Vec3<double>{velocity / size[1] * y, 0, 0}) / velocity;
      if (!(error <= worst)) worst = error;
    }
    trial.row(collision + ": relaxed profile, largest error over image velocity", worst, {0, "u = gdot y + constant"},
              absolute(1e-9));
  }
  for (const Cells& blocks : {Cells{2, 2, 1}, Cells{1, 3, 2}, Cells{4, 1, 1}}) {
    FluidSetup setup = sheared_box(size, "TRT", velocity);
    setup.grid.blocks = blocks;
    Flow flow(trial, setup, "L10, blocks");
    flow.initialise([&](const Cells& c) { return lively_state(c, size); });
    flow.advance(early);
    const std::vector<double> now = flow.fluid().populations(trial.team());
    double different = 0;
    for (std::size_t k = 0; k < bits.size(); ++k) different += now[k] != bits[k];
    trial.row(fmt::format("{} x {} x {} blocks: populations with other bits", blocks[0], blocks[1], blocks[2]),
              different, {0, "one block"}, absolute(0));
  }
}

}  // namespace stresslet::validation
