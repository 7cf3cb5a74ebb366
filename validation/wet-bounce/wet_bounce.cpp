/// Lubricated approach and wet rebound of the discrete-element model, without gravity: two equal spheres head on, and a
/// sphere onto a wall. St is the Stokes number of the impact, mV/(6 pi eta a^2) of a sphere that meets a wall, m* V/(6
/// pi eta a*^2) of a pair with m* = m/2, a* = a/2, V the speed at the distance h0.
///
/// Approach, force inverse to the gap: V/V0 = 1 - ln(h0/h)/St.
/// Rebound from a contact of restitution e: e_wet = e (1 - L/St) - L/St, none if negative; L = ln(h0/h_c) where the
/// film ends with the contact at h_c (Davis, Serayssol & Hinch, J. Fluid Mech. 163 (1986) 479, with a roughness
/// cut-off). Here the film keeps the resistance of h_c from there down to contact at h = 0, which is as much again as a
/// factor e in the gap: L = ln(h0/h_c) + 1.
#include <cmath>
#include <optional>

#include "stresslet/base/constants.hpp"
#include "stresslet/simulation/step.hpp"
#include "validation/harness/trial.hpp"

namespace stresslet::validation {

namespace {

constexpr double radius = 1, far = 1e-4;  ///< h0: where all but the inverse of the gap is below a thousandth

struct Impact {
  bool wall = false;
  double stokes_number = 0;
  double end = 1e-6;       ///< gap at which the resistance stops to grow, h_c
  double restitution = 1;  ///< of the dry contact
  double overlap = 5e-3;   ///< largest one of an impact without film, over h_c

  double mass() const { return 1; }
  double reduced_mass() const { return wall ? mass() : mass() / 2; }
  double reduced_radius() const { return wall ? radius : radius / 2; }
  /// Speed of approach at h0, viscosity 1.
  double speed() const { return stokes_number * 6 * pi * reduced_radius() * reduced_radius() / reduced_mass(); }
  double contact_time() const { return pi * overlap * end / speed(); }
};

Suspension suspension(const Impact& impact, double step) {
  Suspension s;
  s.physics.contact.stiffness = impact.reduced_mass() * std::pow(pi / impact.contact_time(), 2);
  s.physics.contact.damping_ratio = impact.restitution < 1 ? damping_ratio(impact.restitution) : 0;
  s.physics.lubrication_law = "normal";
  // In units of the pair's d_eff = a and of the sphere's d = 2a at a wall.
  const double unit = impact.wall ? 2 * radius : radius;
  s.physics.cutoffs = {impact.end / unit, 0.1};
  s.physics.drag = s.physics.stresslet = false;
  s.time.scheme = "explicit", s.time.step = step;
  const double length = 16 * radius, middle = length / 2;
  s.box = {impact.wall ? BoxKind::walls : BoxKind::periodic, {length, length, length}, 0, 0};
  s.list = VerletList({s.physics.cutoffs.outer}, 0.5 * radius);
  const std::size_t count = impact.wall ? 1 : 2;
  s.state.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double y = impact.wall ? radius + far : middle + (i ? 0.5 : -0.5) * (2 * radius + far);
    const double u = impact.wall ? -impact.speed() : (i ? -0.5 : 0.5) * impact.speed();
    s.state.set_position(i, {middle, y, middle});
    s.state.set_velocity(i, {0, u, 0});
    s.state.set_angular_velocity(i, {});
    s.state.radius[i] = radius, s.state.density[i] = impact.mass() / (4 * pi / 3 * std::pow(radius, 3));
    s.state.species[i] = 0, s.state.id[i] = std::int32_t(i);
  }
  return s;
}

/// Gap and rate at which it closes.
std::pair<double, double> relative_motion(const Impact& impact, const Suspension& s) {
  if (impact.wall) return {s.state.y[0] - radius, -s.state.uy[0]};
  const std::size_t low = s.state.id[0] == 0 ? 0 : 1;
  return {s.state.y[1 - low] - s.state.y[low] - 2 * radius, s.state.uy[low] - s.state.uy[1 - low]};
}

/// Speed of approach at the gap h over that at h0.
double approach(Trial& trial, const Impact& impact, double h) {
  const double speed = impact.speed();
  // A hundredth of the time in which the film changes: the gap at the end, closed at full speed.
  Suspension s = suspension(impact, 0.01 * h / speed);
  start(s, trial.team());
  for (;;) {
    step(s, trial.team());
    const auto [gap, closing] = relative_motion(impact, s);
    if (gap <= h || closing <= 0) return closing / speed;
  }
}

/// Speed back at h0 over that at which the spheres came; 0 without rebound.
double rebound(Trial& trial, const Impact& impact) {
  const double speed = impact.speed();
  Suspension s = suspension(impact, impact.contact_time() / 40);
  start(s, trial.team());
  for (bool touched = false;;) {
    step(s, trial.team());
    const auto [gap, closing] = relative_motion(impact, s);
    touched = touched || gap < 0;
    if (touched && gap > 0 && (gap >= far || closing > -1e-3 * speed)) return gap >= far ? -closing / speed : 0;
    if (!touched && closing < 1e-3 * speed) return 0;
  }
}

}  // namespace

void wet_bounce(Trial& trial) {
  const std::pair<double, double> approaches[] = {{5, 0.0790}, {10, 0.5395}, {20, 0.7697}, {50, 0.9079}, {100, 0.9540}};
  for (const bool wall : {false, true})
    for (const auto& [stokes_number, expected] : approaches) {
      if (trial.quick() && stokes_number != 10) continue;
      const Impact impact{.wall = wall, .stokes_number = stokes_number, .end = 0.9e-2 * far};
      trial.row(fmt::format("{}, St {}: speed at h0/100", wall ? "sphere and wall" : "two spheres", stokes_number),
                approach(trial, impact, far / 100), {expected, "force inverse to the gap"}, absolute(2e-3));
    }

  // L = ln 100 with the film that is kept below h_c.
  const double dry = 0.97, kept = far / 100 * std::exp(1.0);
  const std::pair<double, double> rebounds[] = {{10, 0.065}, {20, 0.532}, {50, 0.813}, {100, 0.907}, {500, 0.981}};
  Table table{"restitution",
              {{"St", "", ""}, {"e/e_dry", "", ""}, {"closed form", "", ""}, {"exp(-35/St)", "", "fit of experiments"}},
              std::vector<std::vector<double>>(4)};
  for (const auto& [stokes_number, expected] : rebounds) {
    if (trial.quick() && stokes_number != 20) continue;
    const Impact impact{.stokes_number = stokes_number, .end = kept, .restitution = dry};
    const double e = rebound(trial, impact) / dry;
    trial.row(fmt::format("two spheres, St {}: wet over dry restitution", stokes_number), e,
              {expected, "Davis, Serayssol & Hinch 1986"}, absolute(5e-3));
    const double lost = std::log(100.0) / stokes_number;
    for (auto [column, value] :
         {std::pair{0, stokes_number}, {1, e}, {2, 1 - lost - lost / dry}, {3, std::exp(-35 / stokes_number)}})
      table.values[std::size_t(column)].push_back(value);
  }
  trial.row("two spheres, St 9: restitution, below 9.35 none",
            rebound(trial, {.stokes_number = 9, .end = kept, .restitution = dry}), {0, "Davis, Serayssol & Hinch 1986"},
            absolute(0));
  trial.table(table);
}

}  // namespace stresslet::validation
