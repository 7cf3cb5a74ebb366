#include "validation/harness/periodic_array.hpp"

#include <cmath>

#include "stresslet/base/constants.hpp"

namespace stresslet::validation {

double drag_of_cubic_array(Trial& trial, const ResolvedScheme& scheme, int edge, double radius,
                           const Vec3<double>& centre) {
  const double viscosity = scheme.viscosity(), volume = std::pow(edge, 3);
  const double force = 1e-3 * viscosity * viscosity / volume;  // Reynolds number far below 1e-3
  TestSphere sphere;
  sphere.sphere = {centre, radius, {}, {}};
  ResolvedFlow flow(trial, resolved_box({edge, edge, edge}, scheme), scheme, {sphere},
                    fmt::format("array of {} cells, tau {}", edge, scheme.relaxation_time));
  flow.set_force_density({force, 0, 0});
  flow.rest();
  const int interval = int(std::lround(0.25 * radius * radius / viscosity)) + 1;
  double before = 0, mean = 1;
  while (std::abs(mean - before) > 1e-5 * std::abs(mean)) {
    flow.advance(interval);
    before = mean;
    // The halves of the body force and of what the sphere takes cancel in the mean of the steady state.
    mean = flow.mean_velocity().x;
  }
  return flow.load().force.x / (6 * pi * viscosity * radius * mean);
}

ArrayRheology sheared_cubic_lattice(Trial& trial, const ResolvedScheme& scheme, int edge, double radius, double strain,
                                    const Vec3<double>& centre) {
  const double viscosity = scheme.viscosity(), volume = std::pow(edge, 3), middle = 0.5 * (edge - 1);
  const double rate = 0.01 * viscosity / (4 * radius * radius);
  FluidSetup setup = resolved_box({edge, edge, edge}, scheme);
  setup.grid.closure[1] = Closure::sheared;
  setup.shear_velocity_lu = rate * edge;
  TestSphere sphere;
  sphere.motion = Motion::free;
  sphere.sphere = {centre, radius, {rate * (centre.y - middle), 0, 0}, {0, 0, -0.5 * rate}};
  ResolvedFlow flow(trial, setup, scheme, {sphere}, fmt::format("lattice of {} cells, strain {}", edge, strain));
  flow.freeze_shear(strain * edge);
  flow.fill([&](const Cells& c) {
    CellState state;
    state.velocity.x = rate * (c[1] - middle);
    state.strain_rate.xy = 0.5 * rate;
    return state;
  });
  flow.advance_to_steady(2e-4, int(std::lround(2 * radius * radius / viscosity)));
  const SymTensor3<double> stress = (1 / (volume * viscosity * rate)) * flow.load().stresslet;
  return {1 + stress.xy, stress.xx - stress.yy, stress.yy - stress.zz, flow.sphere().sphere.angular_velocity.z / rate};
}

}  // namespace stresslet::validation
