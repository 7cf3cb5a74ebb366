#include "validation/harness/shear_cell.hpp"

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "validation/harness/stokes_fields.hpp"

namespace stresslet::validation {

namespace {

/// Of unit cells: node-centred walls lie on the last rows, half-way walls half a cell outside.
int rows_between(const ShearCell& cell) {
  const int height = int(std::lround(cell.box.y * cell.cells_per_diameter));
  return cell.walls == "velocity" ? height + 1 : height;
}

}  // namespace

ShearResult run_shear_cell(Trial& trial, const ShearCell& cell, const std::string& label, double tolerance,
                           double times) {
  const double a = cell.radius(), viscosity = cell.scheme.viscosity(), rate = cell.shear_rate();
  const double height = cell.box.y * cell.cells_per_diameter;
  const Cells size{int(std::lround(cell.box.x * cell.cells_per_diameter)), rows_between(cell),
                   int(std::lround(cell.box.z * cell.cells_per_diameter))};
  FluidSetup setup = resolved_box(size, cell.scheme);
  add_moving_walls(setup, 0.5 * rate * height, cell.walls);

  const double middle = 0.5 * (size[1] - 1);
  TestSphere sphere;
  sphere.motion = cell.fixed ? Motion::prescribed : Motion::turning;
  sphere.sphere.centre =
      Vec3<double>{std::floor(0.5 * size[0]), std::floor(middle), std::floor(0.5 * size[2])} + cell.shift;
  sphere.sphere.radius = a;
  const double drift = rate * (sphere.sphere.centre.y - middle), spin = cell.fixed ? 0 : -0.5 * rate;
  sphere.sphere.velocity = {drift, 0, 0};
  sphere.sphere.angular_velocity = {0, 0, spin};
  ResolvedFlow flow(trial, setup, cell.scheme, {sphere}, label);
  const auto field = [&](const Vec3<double>& x) {
    return Vec3<double>{drift, 0, 0} + sphere_in_shear(x, a, rate, spin);
  };
  flow.fill([&](const Cells& c) {
    const Vec3<double> x = Vec3<double>{double(c[0]), double(c[1]), double(c[2])} - sphere.sphere.centre;
    CellState state;
    state.velocity = field(x);
    if (norm(x) > a) state.strain_rate = strain_rate_of(field, x);
    return state;
  });
  const int interval = int(std::lround(2 * a * a / viscosity));
  if (times > 0)
    flow.advance(int(std::lround(times * interval)));
  else
    flow.advance_to_steady(tolerance, interval);

  const double scale = 10 * pi / 3 * viscosity * a * a * a * rate;
  ShearResult result;
  result.stresslet = flow.load().stresslet.xy / scale;
  result.kinetic = flow.load().kinetic.xy / scale;
  result.torque = -flow.load().torque.z / scale;
  result.spin = -flow.sphere().sphere.angular_velocity.z / rate;
  result.parts = flow.moment_parts();
  for (double* part : {&result.parts.volume, &result.parts.surface}) *part /= scale;
  for (double& part : result.parts.quarter) part /= scale;
  const double stress = 0.5 * (flow.plane_stress(1) + flow.plane_stress(size[1] - 3));
  result.wall = (stress - viscosity * rate) * height * size[0] * size[2] / scale;
  for (int y = 0; y < size[1]; ++y) {
    const Cells c{int(std::lround(sphere.sphere.centre.x)), y, int(std::lround(sphere.sphere.centre.z))};
    result.height.push_back((y - sphere.sphere.centre.y) / a);
    result.velocity.push_back((flow.velocity(c).x - drift) / (rate * a));
  }
  return result;
}

}  // namespace stresslet::validation
