/// A sphere that settles in a closed box, ten Cate, Nieuwstad, Derksen & Van den Akker, Phys. Fluids 14 (2002) 4012:
/// diameter 15 mm, density 1120 kg/m^3, box 100 x 160 x 100 mm, released from rest with its lowest point 120 mm above
/// the bottom. Measured: the largest velocity, 0.947 (E1) and 0.959 (E3) of the terminal velocity of Abraham's drag
/// law. And a sphere released from rest in a large box, whose first velocities show its inertia.
#include <algorithm>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "validation/harness/resolved_flow.hpp"

namespace stresslet::validation {

namespace {

struct Experiment {
  const char* name;
  double density, viscosity;  ///< kg/m^3, Pa s
  double fastest;             ///< m/s, measured
  double relaxation_time;     ///< of the lattice
};

constexpr double diameter = 0.015, particle_density = 1120, gravity = 9.81, width = 0.1, height = 0.16;

/// The box with the sphere at rest, its centre at `start` above the bottom, under `weight` times its weight.
class Fall {
 public:
  Fall(Trial& trial, const Experiment& e, int cells_per_diameter, double start, double weight)
      : scheme_(default_scheme(e.relaxation_time)),
        dx_(diameter / cells_per_diameter),
        dt_(scheme_.viscosity() * dx_ * dx_ * e.density / e.viscosity),
        flow_(trial, box(), scheme_, {sphere(e, start, weight)}, fmt::format("settling, {}", e.name)) {
    flow_.rest();
  }

  void advance(int steps) { flow_.advance(steps); }
  double time() const { return flow_.steps() * dt_; }
  double speed() { return -flow_.sphere().sphere.velocity.y * dx_ / dt_; }
  double gap() { return (flow_.sphere().sphere.centre.y + 0.5) * dx_ - 0.5 * diameter; }

 private:
  Cells size() const {
    const auto cells = [&](double length) { return int(std::lround(length / dx_)); };
    return {cells(width), cells(height), cells(width)};
  }
  FluidSetup box() const {
    FluidSetup setup = resolved_box(size(), scheme_);
    setup.grid.closure = {Closure::open, Closure::open, Closure::open};
    return setup;
  }
  TestSphere sphere(const Experiment& e, double start, double weight) const {
    const double radius = 0.5 * diameter / dx_, volume = 4 * pi / 3 * std::pow(radius, 3);
    const double ratio = particle_density / e.density;
    TestSphere sphere;
    // The bottom lies half a cell below the first row.
    sphere.sphere.centre = {0.5 * (size()[0] - 1), start / dx_ - 0.5, 0.5 * (size()[2] - 1)};
    sphere.sphere.radius = radius;
    sphere.motion = Motion::free;
    sphere.travels = true;
    sphere.density = ratio;
    sphere.force_lu = {0, -weight * (ratio - 1) * volume * gravity * dt_ * dt_ / dx_, 0};
    return sphere;
  }

  ResolvedScheme scheme_;
  double dx_, dt_;
  ResolvedFlow flow_;
};

double fastest(Trial& trial, const Experiment& e, int cells_per_diameter, Table& table) {
  Fall fall(trial, e, cells_per_diameter, 0.12 + 0.5 * diameter, 1);
  double most = 0;
  for (;;) {
    fall.advance(20);
    const double speed = fall.speed(), gap = fall.gap();
    table.values[0].push_back(fall.time());
    table.values[1].push_back(gap / diameter);
    table.values[2].push_back(speed);
    most = std::max(most, speed);
    if (speed < 0.9 * most || gap < 0.25 * diameter) return most;
  }
}

/// Half-way up, with so little weight that inertia does nothing, scaled back to the whole weight.
double speed_without_inertia(Trial& trial, const Experiment& e, int cells_per_diameter) {
  constexpr double weight = 0.01, settled = 3;  // s
  Fall fall(trial, e, cells_per_diameter, 0.5 * height, weight);
  while (fall.time() < settled) fall.advance(20);
  return fall.speed() / weight;
}

/// In an endless square duct of this width, Happel & Bart, Appl. Sci. Res. 29 (1974) 241, to first order in a/h.
double speed_in_duct(const Experiment& e) {
  const double a = 0.5 * diameter, h = 0.5 * width;
  return 2.0 / 9 * a * a * (particle_density - e.density) * gravity / e.viscosity * (1 - 1.903266 * a / h);
}

/// Velocity of a sphere released from rest under a constant force F, step by step, over F/(6 pi eta a): the equation of
/// Basset, Boussinesq & Oseen, added mass of half the fluid displaced, history of the acceleration. Lattice units.
std::vector<double> released(double density, double radius, double viscosity, int steps) {
  const double drag = 6 * pi * viscosity * radius, volume = 4 * pi / 3 * std::pow(radius, 3);
  const double history = 6 * radius * radius * std::sqrt(pi * viscosity);  // times the integral of dU/sqrt(t - t')
  std::vector<double> velocity{0}, change{0};
  for (int k = 1; k <= steps; ++k) {
    double past = 0;
    for (int j = 1; j < k; ++j)
      past += 2 * change[std::size_t(j)] * (std::sqrt(k - j + 1.0) - std::sqrt(double(k - j)));
    const double pull = drag * (1 - velocity.back()) - history * past;
    change.push_back(pull / ((density + 0.5) * volume + drag + 2 * history));
    velocity.push_back(velocity.back() + change.back());
  }
  return velocity;
}

/// In a periodic box, until half a square of its radius over the viscosity has passed.
void release(Trial& trial, double density) {
  const int edge = trial.choose(72, 48);
  const double radius = trial.choose(5, 4), speed = 1e-3;
  const ResolvedScheme scheme = default_scheme(0.6);
  TestSphere sphere;
  sphere.sphere.centre = {0.5 * edge + 0.3, 0.5 * edge + 0.2, 0.5 * edge + 0.4};
  sphere.sphere.radius = radius;
  sphere.motion = Motion::free;
  sphere.travels = true;
  sphere.density = density;
  sphere.force_lu = {0, 6 * pi * scheme.viscosity() * radius * speed, 0};
  const std::string name = fmt::format("released, density ratio {}", density);
  ResolvedFlow flow(trial, resolved_box({edge, edge, edge}, scheme), scheme, {sphere}, name);
  flow.rest();
  const int steps = int(0.5 * radius * radius / scheme.viscosity());
  const std::vector<double> expected = released(density, radius, scheme.viscosity(), steps);
  for (const int part : {4, 2, 1}) {
    flow.advance(steps / part - int(flow.steps()));
    trial.row(fmt::format("{}: velocity after {} steps", name, steps / part), flow.sphere().sphere.velocity.y / speed,
              {expected[std::size_t(steps / part)], "Basset, Boussinesq & Oseen"}, relative(0.03));
  }
}

}  // namespace

void settling(Trial& trial) {
  for (const double density : {1.0, 2.0, 8.0}) release(trial, density);
  const int cells = trial.choose(12, 6);
  trial.parameter("cells per diameter", double(cells));
  const Experiment experiments[] = {{"E1", 970, 0.373, 0.03599, trial.choose(1.5, 1.0)},
                                    {"E3", 962, 0.113, 0.08727, 0.65}};
  for (const Experiment& e : experiments) {
    if (trial.quick() && e.relaxation_time != 1.0) continue;
    Table table{fmt::format("settling-{}", e.name),
                {{"t", "s", ""}, {"gap", "d", "to the bottom"}, {"speed", "m/s", "downwards"}},
                {{}, {}, {}}};
    const double found = fastest(trial, e, cells, table);
    trial.row(fmt::format("{}: largest velocity, m/s", e.name), found, {e.fastest, "ten Cate et al. 2002, measured"},
              relative(trial.choose(0.03, 0.05)));
    trial.table(table);
  }
  if (trial.quick()) return;
  trial.row("E1 without inertia: velocity, m/s", speed_without_inertia(trial, experiments[0], cells),
            {speed_in_duct(experiments[0]), "Happel & Bart 1974, square duct; next term some 0.7 %"}, relative(0.01));
}

}  // namespace stresslet::validation
