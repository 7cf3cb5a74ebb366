/// What a uniform force density F does under each forcing law.
///
/// In a periodic box: u = F t to round-off, with half a step's force in u. And the stress each law leaves: with
/// v = sum f c and rho = 1, the incoming populations of a flow without strain should hold
///   Pi = sum f c c - 1/3 = v v - F F / 4
/// (Guo's transformation of u u, u = v + F/2). Iterating the second moment of each law with one relaxation time tau,
/// Pi' = Pi - (Pi - Pi_target) / tau + Pi_added, gives the rest it leaves in the end, over F F:
///   Guo 0,  He 0 + O(u^3),  exact difference 1/4,  velocity shift (tau - 1/2)^2.
///
/// The strain rate read from the populations has to stay zero, up to order F F.
///
/// Between walls across the force: a column at rest, d rho / dy = 3 F.
#include <algorithm>
#include <cmath>

#include "stresslet/lattice/laws.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

Flow periodic_flow(Trial& trial, const std::string& collision, const std::string& forcing, double relaxation_time,
                   const Vec3<double>& force) {
  FluidSetup setup = periodic_box("D3Q19", {4, 4, 4}, collision, relaxation_time);
  setup.forcing = forcing;
  Flow flow(trial, setup, "L13");
  flow.fluid().set_force_density(force);
  flow.rest();
  return flow;
}

/// Largest |u - F t| over |F t|.
double velocity_error(Trial& trial, const std::string& collision, const std::string& forcing) {
  const Vec3<double> force{2e-6, -1e-6, 3e-6};
  Flow flow = periodic_flow(trial, collision, forcing, 0.8, force);
  constexpr int steps = 1000;
  flow.advance(steps);
  double worst = 0;
  for (const CellState& s : flow.states()) {
    const double error = norm(s.velocity / double(steps) - force) / norm(force);
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

struct Spurious {
  double stress, strain_rate;  // (Pi_xx - v v + F F / 4) / F F, S_xx / (u F)
};

Spurious spurious(Trial& trial, const std::string& forcing, double relaxation_time) {
  const double force = 1e-5;
  Flow flow = periodic_flow(trial, "BGK", forcing, relaxation_time, {force, 0, 0});
  flow.advance(40);  // |1 - 1/tau|^40 forgets the start; u^3 is still small
  const std::vector<double> f = flow.fluid().populations(trial.team());
  const std::size_t cells = f.size() / D3Q19::size;
  double stress = 0, momentum = 0;
  for (int i = 0; i < D3Q19::size; ++i) {
    const int c = D3Q19::velocity[std::size_t(i)][0];
    stress += f[std::size_t(i) * cells] * c * c;
    momentum += f[std::size_t(i) * cells] * c;
  }
  const CellState state = flow.states().front();
  return {(stress - momentum * momentum) / (force * force) + 0.25, state.strain_rate.xx / (state.velocity.x * force)};
}

struct Column {
  double velocity, density;  // largest |u| over F, largest error of the density over 3 F H
};

Column column_at_rest(Trial& trial, const std::string& forcing) {
  constexpr int cells = 16;
  const double force = 1e-5;
  FluidSetup setup = periodic_box("D3Q19", {4, cells, 4}, "TRT", 0.8);
  setup.forcing = forcing;
  add_walls(setup, 1);
  Flow flow(trial, setup, "L13");
  flow.fluid().set_force_density({0, force, 0});
  const auto density = [&](int y) { return 1 + 3 * force * (y + 0.5 - 0.5 * cells); };
  flow.initialise([&](const Cells& c) {
    CellState s;
    s.density = density(c[1]);
    return s;
  });
  flow.advance(4000);
  Column found{0, 0};
  const std::vector<CellState> states = flow.states();
  for (std::size_t k = 0; k < states.size(); ++k) {
    found.velocity = std::max(found.velocity, norm(states[k].velocity) / force);
    found.density =
        std::max(found.density, std::abs(states[k].density - density(int(k) / 4 % cells)) / (3 * force * cells));
  }
  return found;
}

}  // namespace

void force_schemes(Trial& trial) {
  trial.parameter("stencil", "D3Q19");
  trial.parameter("relaxation time", 0.8);
  ForcingLaws::for_each([&](auto forcing) {
    using Forcing = typename decltype(forcing)::type;
    if constexpr (!std::is_same_v<Forcing, NoForce>) {
      const std::string name(Forcing::name);
      for (const std::string& collision : CollisionLaws::names())
        trial.row(fmt::format("{}, {}: velocity, relative error after 1000 steps", name, collision),
                  velocity_error(trial, collision, name), {0, "u = F t"}, absolute(1e-11));
      for (const double tau : {0.6, 0.8, 1.5}) {
        double rest = 0;
        if (name == ExactDifference::name) rest = 0.25;
        if (name == VelocityShift::name) rest = (tau - 0.5) * (tau - 0.5);
        const Spurious found = spurious(trial, name, tau);
        trial.row(fmt::format("{}, tau {}: spurious stress over F F", name, tau), found.stress,
                  {rest, "moment recursion"}, absolute(5e-5));
        trial.row(fmt::format("{}, tau {}: strain rate over u F", name, tau), found.strain_rate, {0, "no strain"},
                  absolute(0.03));
      }
      const Column column = column_at_rest(trial, name);
      trial.row(name + ": column at rest, largest velocity over F", column.velocity, {0, "hydrostatics"},
                absolute(1e-10));
      trial.row(name + ": column at rest, largest error of density over its rise", column.density, {0, "hydrostatics"},
                absolute(1e-9));
    }
  });
}

}  // namespace stresslet::validation
