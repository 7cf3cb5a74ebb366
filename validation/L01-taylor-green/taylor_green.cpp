/// Taylor-Green vortices in a periodic square of N cells, k = 2 pi / N:
///   u = -U cos kx sin ky e^{-2 nu k^2 t},  v = U sin kx cos ky e^{-2 nu k^2 t},
///   p = -(rho U^2 / 4)(cos 2kx + cos 2ky) e^{-4 nu k^2 t},
/// an exact solution of the Navier-Stokes equations (Taylor & Green, Proc. R. Soc. A 158 (1937) 499). Diffusive
/// scaling: Mach number ~ 1/N at fixed relaxation time, so that compressibility and discretisation both fall as N^-2.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

struct Vortices {
  int cells;
  double speed;
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
};

struct Found {
  double viscosity, energy_decay;         // over their exact values
  double velocity_error, pressure_error;  // relative L2
};

Found measure(Trial& trial, const std::string& collision, double relaxation_time, int cells, double mach) {
  const Vortices vortices{cells, mach * std::sqrt(speed_of_sound_squared)};
  const double k = vortices.wave_number(), rate = 2 * kinematic_viscosity_lu(relaxation_time) * k * k;
  Flow flow(trial, periodic_box("D2Q9", {cells, cells, 1}, collision, relaxation_time),
            fmt::format("L1, {} at {} cells", collision, cells));
  flow.initialise([&](const Cells& c) { return vortices.state(c, 1); });
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
  return {-std::log(amplitude / start_energy) / (rate * steps), -std::log(energy / start_energy) / (2 * rate * steps),
          relative_l2_error(velocity, exact_velocity), relative_l2_error(pressure, exact_pressure)};
}

}  // namespace

void taylor_green(Trial& trial) {
  const std::vector<int> sizes = trial.choose<std::vector<int>>({16, 32, 64}, {8, 16, 32});
  const int finest = sizes.back();
  const double mach = 0.02, relaxation_time = 0.8;
  trial.parameter("stencil", "D2Q9");
  trial.parameter("cells", double(finest));
  trial.parameter("Mach number at the finest grid", mach);
  trial.parameter("relaxation time", relaxation_time);

  const std::string source = "Taylor & Green 1937";
  for (const std::string& collision : CollisionLaws::names()) {
    const Found found = measure(trial, collision, relaxation_time, finest, mach);
    trial.row(collision + ": viscosity over (tau - 1/2)/3", found.viscosity, {1, source},
              relative(trial.choose(1e-3, 4e-3)));
    trial.row(collision + ": decay rate of kinetic energy over 4 nu k^2", found.energy_decay, {1, source},
              relative(trial.choose(1e-3, 4e-3)));
  }
  for (const double tau : {0.55, 1.5}) {
    const Found found = measure(trial, "TRT", tau, finest, mach);
    trial.row(fmt::format("TRT, tau {}: viscosity over (tau - 1/2)/3", tau), found.viscosity, {1, source},
              relative(trial.choose(1e-3, 4e-3)));
  }
  std::vector<double> grid, velocity, pressure;
  for (const int cells : sizes) {
    const Found found = measure(trial, "TRT", relaxation_time, cells, mach * finest / cells);
    grid.push_back(cells);
    velocity.push_back(found.velocity_error);
    pressure.push_back(found.pressure_error);
  }
  trial.row("velocity, relative L2 error", velocity.back(), {0, source}, absolute(trial.choose(1e-3, 4e-3)));
  trial.row("pressure, relative L2 error", pressure.back(), {0, source}, absolute(trial.choose(2e-2, 8e-2)));
  trial.order_rows("velocity", sizes, velocity, 2, 1.8, 2.3);
  trial.order_rows("pressure", sizes, pressure, 2, 1.8, 2.3);
  trial.table({"convergence",
               {{"cells", "", ""}, {"velocity_error", "", ""}, {"pressure_error", "", ""}},
               {grid, velocity, pressure}});
}

}  // namespace stresslet::validation
