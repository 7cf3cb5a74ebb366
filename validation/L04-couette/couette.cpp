/// Plane Couette flow between half-way walls that move along themselves: the linear profile is exact at every node for
/// any collision law, relaxation time and magic parameter, and so is the shear stress read from the populations. The
/// other components hold small stresses of second order in the shear rate, which Navier-Stokes does not know (Burnett);
/// they are not judged.
#include <algorithm>
#include <cmath>

#include "stresslet/lattice/laws.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

struct Channel {
  std::string stencil = "D3Q19", collision = "TRT";
  double relaxation_time = 0.8, magic_parameter = 3.0 / 16;
};

constexpr int cells = 8;
constexpr Vec3<double> low{-0.02, 0, 0.01}, high{0.03, 0, -0.02};

struct Found {
  double velocity = 0, strain_rate = 0;  // largest errors over wall speed, and over wall speed / H
};

Found measure(Trial& trial, const Channel& channel) {
  FluidSetup setup = periodic_box(channel.stencil, {1, cells, 1}, channel.collision, channel.relaxation_time);
  setup.rates.magic_parameter = channel.magic_parameter;
  const bool flat = channel.stencil == "D2Q9";
  const Vec3<double> from = flat ? Vec3<double>{low.x, 0, 0} : low, to = flat ? Vec3<double>{high.x, 0, 0} : high;
  add_walls(setup, 1, from, to);
  Flow flow(trial, setup, fmt::format("L4, {} at tau {}", channel.collision, channel.relaxation_time));
  flow.rest();
  const double time = cells * cells / kinematic_viscosity_lu(channel.relaxation_time);
  flow.advance_to_steady(1e-13, int(time / 2) + 10, int(20 * time) + 10000);

  const Vec3<double> rise = to - from;
  const double scale = norm(rise);
  Found found;
  const std::vector<CellState> states = flow.states();
  for (int c = 0; c < cells; ++c) {
    const CellState& s = states[std::size_t(c)];
    const auto larger = [](double& largest, double value) {
      if (!(value <= largest)) largest = value;
    };
    larger(found.velocity, norm(s.velocity - (from + (c + 0.5) / cells * rise)) / scale);
    const SymTensor3<double> off =
        s.strain_rate - SymTensor3<double>{0, 0, 0, rise.x / (2 * cells), 0, rise.z / (2 * cells)};
    for (const double part : {off.xy, off.yz}) larger(found.strain_rate, std::abs(part) * cells / scale);
  }
  return found;
}

}  // namespace

void couette(Trial& trial) {
  trial.parameter("cells between the walls", double(cells));
  trial.parameter("rise of the velocity along x, lattice units", high.x - low.x);
  trial.parameter("rise of the velocity along z, lattice units", high.z - low.z);
  const auto rows = [&](const std::string& name, const Channel& channel) {
    const Found found = measure(trial, channel);
    trial.row(name + ": largest error of velocity", found.velocity, {0, "linear profile"}, absolute(1e-10));
    trial.row(name + ": largest error of shear rate", found.strain_rate, {0, "linear profile"}, absolute(1e-10));
  };
  for (const std::string& collision : CollisionLaws::names())
    for (const double tau : trial.choose<std::vector<double>>({0.51, 0.8, 3}, {0.8, 3}))
      rows(fmt::format("{}, tau {}", collision, tau), {.collision = collision, .relaxation_time = tau});
  for (const double magic : {1.0 / 12, 1.0 / 4, 1.0})
    rows(fmt::format("TRT, Lambda {:.3g}", magic), {.magic_parameter = magic});
  for (const char* stencil : {"D2Q9", "D3Q27"}) rows(fmt::format("TRT, {}", stencil), {.stencil = stencil});
}

}  // namespace stresslet::validation
