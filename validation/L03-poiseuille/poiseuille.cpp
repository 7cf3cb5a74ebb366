/// Plane Poiseuille flow driven by a uniform force density F between half-way walls H cells apart:
///   u(y) = F y (H - y) / (2 nu) + u_s,   u_s = (F / (8 nu)) (16 Lambda / 3 - 1),
/// exactly at every node, Lambda = (tau - 1/2)(tau_odd - 1/2): Ginzburg & d'Humieres, Phys. Rev. E 68 (2003) 066614.
/// The parabola is exact at Lambda = 3/16 for any relaxation time; with BGK, Lambda = (tau - 1/2)^2, only at
/// tau = 1/2 + sqrt(3)/4.
#include <cmath>

#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

struct Channel {
  std::string stencil = "D3Q19", collision = "TRT", forcing = "guo";
  double relaxation_time = 0.8, magic_parameter = 3.0 / 16;
  int axis = 1, cells = 8;
};

struct Found {
  double slip;       // mean of u minus parabola, over (F H^2 / 8 nu)
  double deviation;  // largest |u - parabola - mean slip|, over the same
  std::vector<double> position, velocity;
};

constexpr double centre_speed = 0.01;

Found measure(Trial& trial, const Channel& channel) {
  const int h = channel.cells;
  const double viscosity = kinematic_viscosity_lu(channel.relaxation_time),
               force = 8 * viscosity * centre_speed / (h * h);
  Cells size{1, 1, 1};
  size[std::size_t(channel.axis)] = h;
  FluidSetup setup = periodic_box(channel.stencil, size, channel.collision, channel.relaxation_time);
  setup.rates.magic_parameter = channel.magic_parameter;
  setup.forcing = channel.forcing;
  add_walls(setup, channel.axis);
  Flow flow(trial, setup, fmt::format("L3, {} at tau {}", channel.collision, channel.relaxation_time));
  const bool along_x = channel.axis != 0;
  flow.fluid().set_force_density(along_x ? Vec3<double>{force, 0, 0} : Vec3<double>{0, force, 0});
  flow.rest();
  flow.advance_to_steady(1e-13, int(0.5 * h * h / viscosity) + 10, int(20 * h * h / viscosity) + 10000);

  Found found{
      0, 0, {}, picked(flow.states(), [&](const CellState& s) { return along_x ? s.velocity.x : s.velocity.y; })};
  std::vector<double> difference;
  for (int c = 0; c < h; ++c) {
    const double y = c + 0.5;
    found.position.push_back(y / h);
    difference.push_back((found.velocity[std::size_t(c)] - force * y * (h - y) / (2 * viscosity)) / centre_speed);
    found.slip += difference.back() / h;
  }
  found.deviation = largest_difference(difference, std::vector<double>(difference.size(), found.slip));
  return found;
}

/// u_s over F H^2 / (8 nu).
double slip_law(double magic_parameter, int cells) { return (16 * magic_parameter / 3 - 1) / (cells * cells); }

}  // namespace

void poiseuille(Trial& trial) {
  const std::string exact = "parabola, Lambda = 3/16", law = "Ginzburg & d'Humieres 2003";
  const double round_off = 1e-10;
  trial.parameter("cells between the walls", 8.0);
  trial.parameter("centre velocity, lattice units", centre_speed);

  const auto exact_row = [&](const std::string& name, const Channel& channel) {
    const Found found = measure(trial, channel);
    trial.row(name + ": largest error over centre velocity", found.deviation + std::abs(found.slip), {0, exact},
              absolute(round_off));
  };
  for (const double tau : trial.choose<std::vector<double>>({0.51, 0.6, 1, 3}, {0.6, 3}))
    for (const char* collision : {"TRT", "MRT"})
      exact_row(fmt::format("{}, tau {}", collision, tau), {.collision = collision, .relaxation_time = tau});
  exact_row("BGK, tau 1/2 + sqrt(3)/4", {.collision = "BGK", .relaxation_time = 0.5 + std::sqrt(3) / 4});
  for (const int axis : {0, 2}) exact_row(fmt::format("TRT, walls across {}", "xyz"[axis]), {.axis = axis});
  for (const char* stencil : {"D2Q9", "D3Q27"}) exact_row(fmt::format("TRT, {}", stencil), {.stencil = stencil});
  exact_row("TRT, 11 cells", {.cells = 11});
  ForcingLaws::for_each([&](auto forcing) {
    using Forcing = typename decltype(forcing)::type;
    if constexpr (!std::is_same_v<Forcing, NoForce> && !std::is_same_v<Forcing, Guo>)
      exact_row(fmt::format("TRT, force {}", Forcing::name), {.forcing = std::string(Forcing::name)});
  });

  const auto slip_row = [&](const std::string& name, const Channel& channel, double magic_parameter) {
    const Found found = measure(trial, channel);
    trial.row(name + ": slip over centre velocity", found.slip, {slip_law(magic_parameter, channel.cells), law},
              absolute(round_off));
    trial.row(name + ": largest departure from parabola and slip", found.deviation, {0, law}, absolute(round_off));
  };
  for (const double magic : {1.0 / 12, 1.0 / 4, 1.0})
    slip_row(fmt::format("TRT, Lambda {:.3g}", magic), {.magic_parameter = magic}, magic);
  for (const double tau : {0.6, 2.0})
    slip_row(fmt::format("BGK, tau {}", tau), {.collision = "BGK", .relaxation_time = tau}, (tau - 0.5) * (tau - 0.5));

  const Found profile = measure(trial, {});
  trial.table({"profile", {{"y", "H", ""}, {"velocity", "lu", ""}}, {profile.position, profile.velocity}});
}

}  // namespace stresslet::validation
