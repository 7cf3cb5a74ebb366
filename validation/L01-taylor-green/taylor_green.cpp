/// Taylor-Green vortices in a periodic square of N cells, k = 2 pi / N:
///   u = -U cos kx sin ky e^{-2 nu k^2 t},  v = U sin kx cos ky e^{-2 nu k^2 t},
///   p = -(rho U^2 / 4)(cos 2kx + cos 2ky) e^{-4 nu k^2 t},
/// an exact solution of the Navier-Stokes equations (Taylor & Green, Proc. R. Soc. A 158 (1937) 499). Diffusive
/// scaling: Mach number ~ 1/N at fixed relaxation time, so that compressibility and discretisation both fall as N^-2.
///
/// The pressure falls with time, so a weakly compressible fluid converges a little, div u = 12 nu k^2 p / rho. The
/// start contains that part too, u1 = -(3/2) nu k U^2 (sin 2kx, sin 2ky); without it sound waves of relative size k sit
/// on the pressure. A rest of relative size k^2 remains, so the amplitude of the pressure is averaged over a period of
/// sound.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

struct Vortices {
  int cells;
  double speed, viscosity;
  double wave_number() const { return 2 * pi / cells; }

  /// `decay` = e^{-2 nu k^2 t}.
  CellState state(const Cells& c, double decay) const {
    const double k = wave_number(), x = k * c[0], y = k * c[1], u = speed * decay;
    CellState s;
    s.velocity = {-u * std::cos(x) * std::sin(y), u * std::sin(x) * std::cos(y), 0};
    s.density = 1 - 0.75 * u * u * (std::cos(2 * x) + std::cos(2 * y));
    s.strain_rate.xx = u * k * std::sin(x) * std::sin(y);
    s.strain_rate.yy = -s.strain_rate.xx;
    return s;
  }
  CellState start(const Cells& c) const {
    CellState s = state(c, 1);
    const double k = wave_number(), u1 = -1.5 * viscosity * k * speed * speed;
    s.velocity += Vec3<double>{u1 * std::sin(2 * k * c[0]), u1 * std::sin(2 * k * c[1]), 0};
    s.strain_rate +=
        SymTensor3<double>{2 * k * u1 * std::cos(2 * k * c[0]), 2 * k * u1 * std::cos(2 * k * c[1]), 0, 0, 0, 0};
    return s;
  }
};

struct Found {
  double viscosity, energy_decay;         // over their exact values
  double velocity_error, pressure_error;  // relative L2
  double pressure_amplitude;              // over exact, mean over a period of sound
};

/// Amplitude of the pressure over the exact one; `decay` as in Vortices::state.
double pressure_amplitude(Flow& flow, const Vortices& vortices, double decay) {
  const std::vector<CellState> states = flow.states();
  double found = 0, exact = 0;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const double p = vortices.state({int(n) % vortices.cells, int(n) / vortices.cells, 0}, decay).density - 1;
    found += (states[n].density - 1) * p;
    exact += p * p;
  }
  return found / exact;
}

Found measure(Trial& trial, const std::string& collision, double relaxation_time, int cells, double mach) {
  const double viscosity = kinematic_viscosity_lu(relaxation_time);
  const Vortices vortices{cells, mach * std::sqrt(speed_of_sound_squared), viscosity};
  const double k = vortices.wave_number(), rate = 2 * viscosity * k * k;
  Flow flow(trial, periodic_box("D2Q9", {cells, cells, 1}, collision, relaxation_time),
            fmt::format("L1, {} at {} cells", collision, cells));
  flow.initialise([&](const Cells& c) { return vortices.start(c); });
  const int steps = int(std::lround(1 / rate));
  flow.advance(steps);
  const double decay = std::exp(-rate * steps);

  const std::vector<CellState> states = flow.states();
  double amplitude = 0, energy = 0, start_energy = 0;
  std::vector<double> velocity, exact_velocity, pressure, exact_pressure;
  for (std::size_t n = 0; n < states.size(); ++n) {
    const Cells c{int(n) % cells, int(n) / cells, 0};
    const CellState start = vortices.state(c, 1), exact = vortices.state(c, decay);
    amplitude += dot(states[n].velocity, start.velocity);
    start_energy += dot(start.velocity, start.velocity);
    energy += dot(states[n].velocity, states[n].velocity);
    velocity.insert(velocity.end(), {states[n].velocity.x, states[n].velocity.y});
    exact_velocity.insert(exact_velocity.end(), {exact.velocity.x, exact.velocity.y});
    pressure.push_back(states[n].density - 1);
    exact_pressure.push_back(exact.density - 1);
  }
  const int sound_period = int(std::lround(cells / (2 * std::sqrt(speed_of_sound_squared))));
  double amplitude_of_pressure = 0;
  for (int step = 0; step < sound_period; ++step) {
    amplitude_of_pressure += pressure_amplitude(flow, vortices, std::exp(-rate * (steps + step))) / sound_period;
    flow.advance(1);
  }
  return {-std::log(amplitude / start_energy) / (rate * steps), -std::log(energy / start_energy) / (2 * rate * steps),
          relative_l2_error(velocity, exact_velocity), relative_l2_error(pressure, exact_pressure),
          amplitude_of_pressure};
}

}  // namespace

void taylor_green(Trial& trial) {
  const std::string source = "Taylor & Green 1937";
  const double mach = 0.02;
  const int cells = 64;
  trial.parameter("stencil", "D2Q9");
  trial.parameter("viscosity: cells", double(cells));
  trial.parameter("viscosity: Mach number", mach);
  const auto rows = [&](const std::string& collision, double tau) {
    const Found found = measure(trial, collision, tau, cells, mach);
    trial.row(fmt::format("{}, tau {}: viscosity over (tau - 1/2)/3", collision, tau), found.viscosity, {1, source},
              relative(1e-3));
    trial.row(fmt::format("{}, tau {}: decay rate of kinetic energy over 4 nu k^2", collision, tau), found.energy_decay,
              {1, source}, relative(1e-3));
  };
  for (const std::string& collision : CollisionLaws::names()) rows(collision, 0.8);
  rows("TRT", 0.55);

  // At tau 0.8 and Lambda 3/16 the leading error nearly vanishes, which hides the order.
  const std::vector<int> sizes = trial.choose<std::vector<int>>({32, 64, 128}, {16, 32, 64});
  const double relaxation_time = 1;
  trial.parameter("convergence: relaxation time", relaxation_time);
  trial.parameter("convergence: Mach number times cells", mach * cells);
  std::vector<double> grid, velocity, pressure;
  double pressure_error = 0;
  for (const int n : sizes) {
    const Found found = measure(trial, "TRT", relaxation_time, n, mach * cells / n);
    grid.push_back(n);
    velocity.push_back(found.velocity_error);
    pressure.push_back(found.pressure_amplitude - 1);
    pressure_error = found.pressure_error;
  }
  trial.row("TRT, tau 1: velocity, relative L2 error", velocity.back(), {0, source},
            absolute(trial.choose(5e-4, 2e-3)));
  trial.row("TRT, tau 1: pressure, relative L2 error", pressure_error, {0, source}, absolute(trial.choose(5e-3, 2e-2)));
  trial.order_rows("velocity", sizes, velocity, 2, 1.85, 2.15);
  trial.order_rows("pressure amplitude", sizes, pressure, 2, 1.85, 2.15);
  trial.table({"convergence",
               {{"cells", "", ""}, {"velocity_error", "", ""}, {"pressure_error", "", ""}},
               {grid, velocity, pressure}});
}

}  // namespace stresslet::validation
