/// A sphere that settles in a closed box, ten Cate, Nieuwstad, Derksen & Van den Akker, Phys. Fluids 14 (2002) 4012:
/// diameter 15 mm, density 1120 kg/m^3, box 100 x 160 x 100 mm, released from rest with its lowest point 120 mm above
/// the bottom. Measured: the largest velocity, 0.947 (E1) and 0.959 (E3) of the terminal velocity of Abraham's drag
/// law.
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

double fastest(Trial& trial, const Experiment& e, int cells_per_diameter, Table& table) {
  const double diameter = 0.015, gravity = 9.81, particle_density = 1120, nu = e.viscosity / e.density;
  const ResolvedScheme scheme = default_scheme(e.relaxation_time);
  const double dx = diameter / cells_per_diameter, dt = scheme.viscosity() * dx * dx / nu;
  const auto cells = [&](double length) { return int(std::lround(length / dx)); };
  const Cells size{cells(0.1), cells(0.16), cells(0.1)};
  FluidSetup setup = resolved_box(size, scheme);
  setup.grid.closure = {Closure::open, Closure::open, Closure::open};

  const double radius = 0.5 * cells_per_diameter, volume = 4 * pi / 3 * std::pow(radius, 3);
  const double ratio = particle_density / e.density;
  TestSphere sphere;
  // The bottom lies half a cell below the first row.
  sphere.sphere.centre = {0.5 * (size[0] - 1), 0.12 / dx + radius - 0.5, 0.5 * (size[2] - 1)};
  sphere.sphere.radius = radius;
  sphere.motion = Motion::free;
  sphere.travels = true;
  sphere.density = ratio;
  sphere.force_lu = {0, -(ratio - 1) * volume * gravity * dt * dt / dx, 0};
  ResolvedFlow flow(trial, setup, scheme, {sphere}, fmt::format("settling, {}", e.name));
  flow.rest();
  double most = 0;
  for (;;) {
    flow.advance(20);
    const ResolvedSphere& now = flow.sphere().sphere;
    const double speed = -now.velocity.y * dx / dt, gap = (now.centre.y + 0.5 - radius) * dx;
    table.values[0].push_back(flow.steps() * dt);
    table.values[1].push_back(gap / diameter);
    table.values[2].push_back(speed);
    most = std::max(most, speed);
    if (speed < 0.9 * most || gap < 0.25 * diameter) return most;
  }
}

}  // namespace

void settling(Trial& trial) {
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
}

}  // namespace stresslet::validation
