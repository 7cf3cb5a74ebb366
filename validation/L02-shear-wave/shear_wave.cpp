/// A shear wave u = U e_t sin(k.x), e_t across k: amplitude exp(-nu k^2 t) exactly, by Navier-Stokes.
///
/// The lattice obeys its own exact law as well. For k along y the populations that carry momentum along x in the layers
/// c_y = 1, -1, 0 form a closed linear system (j+, j-, j0) with equilibrium J (1/6, 1/6, 2/3), J = j+ + j- + j0, for
/// every stencil whose fourth moments are isotropic: j+ - j- relaxes with the shear rate, j+ + j- and j0 with the odd
/// rate. One step multiplies the wave by the eigenvalue of this 3 x 3 system that is nearest e^{-nu k^2}; the program
/// has to meet it to round-off at any relaxation time.
#include <Eigen/Eigenvalues>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

struct Wave {
  Vec3<double> wave_vector, direction;
};

Wave straight_wave(int cells) { return {{0, 2 * pi / cells, 0}, {1, 0, 0}}; }
Wave tilted_wave(int cells) { return {{2 * pi / cells, 2 * pi / cells, 0}, {std::sqrt(0.5), -std::sqrt(0.5), 0}}; }

constexpr double speed = 1e-3;

Vec3<double> position(const Cells& c) { return {double(c[0]), double(c[1]), double(c[2])}; }

void initialise(Flow& flow, const Wave& wave) {
  flow.initialise([&](const Cells& c) {
    const double phase = dot(wave.wave_vector, position(c));
    CellState s;
    s.velocity = speed * std::sin(phase) * wave.direction;
    const Vec3<double> gradient = 0.5 * speed * std::cos(phase) * wave.wave_vector;
    const Vec3<double>& e = wave.direction;
    s.strain_rate = {2 * gradient.x * e.x, 2 * gradient.y * e.y, 0, gradient.x * e.y + gradient.y * e.x, 0, 0};
    return s;
  });
}

double amplitude(Flow& flow, const Wave& wave) {
  const std::vector<CellState> states = flow.states();
  const Cells& n = flow.size();
  double sum = 0;
  for (std::size_t k = 0; k < states.size(); ++k) {
    const Cells c{int(k) % n[0], int(k) / n[0] % n[1], int(k) / (n[0] * n[1])};
    sum += dot(states[k].velocity, wave.direction) * std::sin(dot(wave.wave_vector, position(c)));
  }
  return 2 * sum / double(states.size());
}

/// Viscosity from the decay to 1/e, over (tau - 1/2)/3.
double viscosity(Trial& trial, const std::string& stencil, const std::string& collision, double relaxation_time,
                 int cells, bool tilted) {
  const Wave wave = tilted ? tilted_wave(cells) : straight_wave(cells);
  Flow flow(trial, periodic_box(stencil, {tilted ? cells : 4, cells, 1}, collision, relaxation_time),
            fmt::format("L2, {} at {} cells", collision, cells));
  initialise(flow, wave);
  const double rate = kinematic_viscosity_lu(relaxation_time) * dot(wave.wave_vector, wave.wave_vector);
  const int steps = int(std::lround(1 / rate));
  flow.advance(steps);
  return -std::log(amplitude(flow, wave) / speed) / (rate * steps);
}

/// Decay rate a step of the discrete scheme, straight wave.
double scheme_decay(const RelaxationRates& rates, double wave_number) {
  using Complex = std::complex<double>;
  Eigen::Matrix3d collide;  // of (j+, j-, j0)
  for (int column = 0; column < 3; ++column) {
    const Eigen::Vector3d j = Eigen::Vector3d::Unit(column);
    const double total = j.sum(), stress = j[0] - j[1], odd = j[0] + j[1];
    const double stress_after = stress - rates.shear * stress, odd_after = odd - rates.odd * (odd - total / 3);
    collide.col(column) << 0.5 * (odd_after + stress_after), 0.5 * (odd_after - stress_after),
        j[2] - rates.odd * (j[2] - 2 * total / 3);
  }
  const Complex shift = std::exp(Complex(0, -wave_number));
  const Eigen::Vector3cd stream(shift, std::conj(shift), 1);
  const Eigen::Matrix3cd step = stream.asDiagonal() * collide.cast<Complex>();
  const auto eigenvalues = Eigen::ComplexEigenSolver<Eigen::Matrix3cd>(step, false).eigenvalues();
  const double expected = std::exp(-(1 / rates.shear - 0.5) / 3 * wave_number * wave_number);
  Complex nearest = eigenvalues[0];
  for (const Complex& e : eigenvalues)
    if (std::abs(e - expected) < std::abs(nearest - expected)) nearest = e;
  return -std::log(nearest.real());
}

/// Decay rate a step after the start has been forgotten, over that of the scheme.
template <class Collision>
double decay_over_scheme(Trial& trial, const std::string& stencil, double relaxation_time, int cells) {
  FluidSetup setup = periodic_box(stencil, {4, cells, 1}, std::string(Collision::name), relaxation_time);
  const Wave wave = straight_wave(cells);
  Flow flow(trial, setup, fmt::format("L2, {} at tau {}", Collision::name, relaxation_time));
  initialise(flow, wave);
  constexpr int steps = 600;
  flow.advance(steps);
  const double before = amplitude(flow, wave);
  flow.advance(steps);
  return std::log(before / amplitude(flow, wave)) / steps /
         scheme_decay(Collision::rates(setup.rates), wave.wave_vector.y);
}

}  // namespace

void shear_wave(Trial& trial) {
  const std::vector<int> sizes = trial.choose<std::vector<int>>({16, 32, 64}, {8, 16, 32});
  const std::vector<double> scheme_times = trial.choose<std::vector<double>>({0.51, 0.6, 1, 3}, {0.51, 3});
  const int finest = sizes.back();
  const double relaxation_time = 0.8;
  trial.parameter("cells a wave length", double(finest));
  trial.parameter("relaxation time", relaxation_time);
  trial.parameter("amplitude, lattice units", speed);
  const double bound = trial.choose(1e-3, 4e-3);
  for (const std::string& collision : CollisionLaws::names())
    for (const bool tilted : {false, true})
      trial.row(fmt::format("{}, D3Q19, {}: viscosity over (tau - 1/2)/3", collision, tilted ? "tilted" : "straight"),
                viscosity(trial, "D3Q19", collision, relaxation_time, finest, tilted), {1, "exp(-nu k^2 t)"},
                relative(bound));
  for (const char* stencil : {"D2Q9", "D3Q27"})
    trial.row(fmt::format("TRT, {}, tilted: viscosity over (tau - 1/2)/3", stencil),
              viscosity(trial, stencil, "TRT", relaxation_time, finest, true), {1, "exp(-nu k^2 t)"}, relative(bound));

  // Laws and relaxation times whose leading error does not vanish by chance.
  std::vector<double> straight, tilted;
  for (const int cells : sizes) {
    straight.push_back(viscosity(trial, "D3Q19", "TRT", 0.8, cells, false) - 1);
    tilted.push_back(viscosity(trial, "D3Q19", "BGK", 1, cells, true) - 1);
  }
  trial.order_rows("viscosity, straight (TRT, tau 0.8)", sizes, straight, 2, 1.85, 2.15);
  trial.order_rows("viscosity, tilted (BGK, tau 1)", sizes, tilted, 2, 1.85, 2.15);
  Stencils::for_each([&](auto stencil) {
    CollisionLaws::for_each([&](auto collision) {
      using Collision = typename decltype(collision)::type;
      const std::string name(decltype(stencil)::type::name);
      double worst = 1;
      for (const double tau : scheme_times) {
        const double found = decay_over_scheme<Collision>(trial, name, tau, 32);
        if (!(std::abs(found - 1) <= std::abs(worst - 1))) worst = found;
      }
      trial.row(fmt::format("{}, {}: decay of the scheme, worst of tau 0.51 to 3", Collision::name, name), worst,
                {1, "3 x 3 eigenvalue"}, relative(1e-8));
    });
  });
}

}  // namespace stresslet::validation
