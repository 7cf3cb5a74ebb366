/// Flow between plates at y = +-h under the force density F cos(omega t):
///   u = Re{ F / (i omega) [1 - cosh(sqrt(i omega/nu) y) / cosh(sqrt(i omega/nu) h)] e^{i omega t} },
/// alpha = h sqrt(omega/nu) (Womersley, J. Physiol. 127 (1955) 553, for plates). The force of the step from n to n + 1
/// is that of time n, when populations collide; the velocity of time n holds half of it.
///
/// Starts from the exact flow, so that what is left of the start is the discretisation error of the first period, and
/// is forgotten over several more. Diffusive scaling: steps a period ~ (2h)^2 at a fixed relaxation time.
#include <cmath>
#include <complex>

#include "stresslet/base/constants.hpp"
#include "stresslet/lattice/laws.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

using Complex = std::complex<double>;

struct Oscillation {
  double alpha;
  int cells, period;  // 2h and 2 pi / omega

  double half_height() const { return 0.5 * cells; }
  double frequency() const { return 2 * pi / period; }
  double viscosity() const { return half_height() * half_height() * frequency() / (alpha * alpha); }
  Complex root() const { return std::sqrt(Complex(0, frequency() / viscosity())); }
  double position(int c) const { return c + 0.5 - half_height(); }

  /// Per unit force; cosh ratio by exponentials, which do not overflow.
  Complex velocity(double y) const {
    const Complex a = root();
    const double h = half_height();
    return (1.0 - (std::exp(a * (y - h)) + std::exp(-a * (y + h))) / (1.0 + std::exp(-2.0 * a * h))) /
           Complex(0, frequency());
  }
  Complex velocity_gradient(double y) const {
    const Complex a = root();
    const double h = half_height();
    return -a * (std::exp(a * (y - h)) - std::exp(-a * (y + h))) / (1.0 + std::exp(-2.0 * a * h)) /
           Complex(0, frequency());
  }
};

/// Steps a period that put the relaxation time nearest `relaxation_time`.
int period_of(double alpha, int cells, double relaxation_time) {
  return int(std::lround(2 * pi * 0.25 * cells * cells / (alpha * alpha * kinematic_viscosity_lu(relaxation_time))));
}

struct Found {
  double amplitude, phase;  // at the centre: over the exact one, minus the exact one
  double error;             // relative L2 error of the complex profile
  std::vector<Complex> profile;
};

Found measure(Trial& trial, const std::string& collision, const Oscillation& o, int periods) {
  FluidSetup setup = periodic_box("D2Q9", {o.cells, 1, 1}, collision, relaxation_time_of(o.viscosity()));
  setup.forcing = "guo";
  add_walls(setup, 0);
  Flow flow(trial, setup, fmt::format("L6, {} at alpha {}, {} cells", collision, o.alpha, o.cells));
  const double force = 1e-3 / std::abs(o.velocity(0));
  const auto force_at = [&](int step) {
    flow.fluid().set_force_density({0, force * std::cos(o.frequency() * step), 0});
  };
  force_at(0);
  flow.initialise([&](const Cells& c) {
    const double y = o.position(c[0]);
    CellState s;
    s.velocity.y = force * o.velocity(y).real();
    s.strain_rate.xy = 0.5 * force * o.velocity_gradient(y).real();
    return s;
  });
  for (int step = 0; step < periods * o.period; ++step) {
    force_at(step);
    flow.advance(1);
  }
  std::vector<Complex> sum(std::size_t(o.cells), 0);
  for (int step = 0; step < o.period; ++step) {
    force_at(step);
    const std::vector<CellState> states = flow.states();
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] += 2.0 / o.period * states[c].velocity.y / force * std::polar(1.0, -o.frequency() * step);
    flow.advance(1);
  }
  // The centre lies between two cells where their number is even; both see the same.
  const std::size_t centre = sum.size() / 2;
  const Complex exact_centre = o.velocity(o.position(int(centre)));
  double difference = 0, norm = 0;
  for (std::size_t c = 0; c < sum.size(); ++c) {
    const Complex exact = o.velocity(o.position(int(c)));
    difference += std::norm(sum[c] - exact);
    norm += std::norm(exact);
  }
  return {std::abs(sum[centre] / exact_centre), std::arg(sum[centre] / exact_centre), std::sqrt(difference / norm),
          sum};
}

struct Regime {
  double alpha, relaxation_time;
  int periods;  // before the one that is measured
  std::vector<int> full, quick;
};

}  // namespace

void womersley(Trial& trial) {
  const std::vector<Regime> regimes{{1, 0.8, 2, {16, 32, 64}, {8, 16, 32}},
                                    {4, 0.8, 4, {32, 64, 128}, {16, 32, 64}},
                                    {10, 0.8, 12, {64, 128, 256}, {32, 64, 128}}};
  const double bound = trial.choose(2e-4, 8e-4);
  for (const Regime& regime : regimes) {
    const std::vector<int>& sizes = trial.quick() ? regime.quick : regime.full;
    const std::string name = fmt::format("alpha {}", regime.alpha), source = "closed form";
    trial.parameter(name + ": cells between the plates", double(sizes.back()));
    std::vector<double> errors;
    for (const int cells : sizes) {
      const Oscillation o{regime.alpha, cells, period_of(regime.alpha, cells, regime.relaxation_time)};
      const Found found = measure(trial, "TRT", o, regime.periods);
      errors.push_back(found.error);
      if (cells != sizes.back()) continue;
      trial.parameter(name + ": steps a period", double(o.period));
      trial.parameter(name + ": relaxation time", relaxation_time_of(o.viscosity()));
      trial.row("TRT, " + name + ": amplitude at the centre over exact", found.amplitude, {1, source}, relative(bound));
      trial.row("TRT, " + name + ": phase at the centre minus exact, rad", found.phase, {0, source}, absolute(bound));
      trial.row("TRT, " + name + ": complex profile, relative L2 error", found.error, {0, source}, absolute(bound));
      Table profile{fmt::format("profile_alpha_{}", regime.alpha),
                    {{"y", "h", ""},
                     {"amplitude", "F/omega", ""},
                     {"phase", "rad", ""},
                     {"exact_amplitude", "F/omega", ""},
                     {"exact_phase", "rad", ""}},
                    std::vector<std::vector<double>>(5)};
      for (int c = 0; c < cells; ++c) {
        const Complex value = o.frequency() * found.profile[std::size_t(c)];
        const Complex exact = o.frequency() * o.velocity(o.position(c));
        const double line[] = {o.position(c) / o.half_height(), std::abs(value), std::arg(value), std::abs(exact),
                               std::arg(exact)};
        for (std::size_t k = 0; k < 5; ++k) profile.values[k].push_back(line[k]);
      }
      trial.table(std::move(profile));
    }
    trial.order_rows(name + ", profile", sizes, errors, 2, trial.choose(1.9, 1.8), trial.choose(2.1, 2.25));
  }
  const int cells = trial.choose(64, 32);
  for (const char* collision : {"BGK", "MRT"}) {
    const Found found = measure(trial, collision, {4, cells, period_of(4, cells, 0.8)}, 4);
    trial.row(fmt::format("{}, alpha 4: amplitude at the centre over exact", collision), found.amplitude,
              {1, "closed form"}, relative(bound));
    trial.row(fmt::format("{}, alpha 4: phase at the centre minus exact, rad", collision), found.phase,
              {0, "closed form"}, absolute(bound));
  }
}

}  // namespace stresslet::validation
