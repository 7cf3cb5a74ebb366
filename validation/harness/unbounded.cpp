#include "validation/harness/unbounded.hpp"

#include <algorithm>
#include <cmath>

namespace stresslet::validation {

namespace {

using Field = std::function<Vec3<double>(const Vec3<double>&)>;

/// Velocity, rotation and strain rate at a point with their means over a unit sphere there (Faxen).
struct Ambient {
  Vec3<double> velocity, rotation;
  SymTensor3<double> strain;
};

Ambient ambient_at(const Field& field, const Vec3<double>& x) {
  // In a Stokes flow the mean over the sphere's surface is u + (a^2/6) lap u, that of the strain over the force
  // distribution E + (a^2/10) lap E: taken by sampling six points, exact for both up to the fourth derivative.
  constexpr double h = 0.3;
  const Vec3<double> axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto laplacian = [&](const auto& of, const Vec3<double>& at) {
    auto sum = -6.0 * of(at);
    for (const Vec3<double>& e : axes) sum = sum + of(at + h * e) + of(at - h * e);
    return (1 / (h * h)) * sum;
  };
  const auto strain = [&](const Vec3<double>& at) { return strain_rate_of(field, at); };
  constexpr double d = 1e-3;
  const auto slope = [&](const Vec3<double>& e) { return (0.5 / d) * (field(x + d * e) - field(x - d * e)); };
  const Vec3<double> dx = slope(axes[0]), dy = slope(axes[1]), dz = slope(axes[2]);
  return {field(x) + (1.0 / 6) * laplacian(field, x), 0.5 * Vec3<double>{dy.z - dz.y, dz.x - dx.z, dx.y - dy.x},
          strain(x) + 0.1 * laplacian(strain, x)};
}

Vec3<double> background(const Unbounded& setup, const Vec3<double>& x) {
  return Vec3<double>{setup.shear_rate * (x.y - setup.wall.value_or(0)), 0, 0} + setup.strain * x;
}

/// Flow of the background, of all spheres but `except`, and of what a wall makes of all; viscosity and radius 1.
Vec3<double> flow_at(const Unbounded& setup, const std::vector<Strength>& strengths, std::size_t except,
                     const Vec3<double>& x) {
  Vec3<double> u = background(setup, x);
  for (std::size_t k = 0; k < setup.spheres.size(); ++k) {
    const Vec3<double>& centre = setup.spheres[k].centre;
    if (k != except) u += disturbance(x - centre, 1, 1, strengths[k]);
    if (!setup.wall) continue;
    const Vec3<double> foot{0, *setup.wall, 0};
    u += wall_image([&](const Vec3<double>& y) { return disturbance(y + foot - centre, 1, 1, strengths[k]); },
                    [&](const Vec3<double>& y) { return disturbance_pressure(y + foot - centre, strengths[k]); }, 1,
                    x - foot);
  }
  return u;
}

/// Exact to some power of a/(distance of the spheres). Sets the velocities that are free.
std::vector<Strength> strengths_by_reflection(Unbounded& setup) {
  std::vector<Strength> strengths(setup.spheres.size());
  for (int round = 0; round < 25; ++round)
    for (std::size_t k = 0; k < setup.spheres.size(); ++k) {
      UnboundedSphere& s = setup.spheres[k];
      const Ambient ambient =
          ambient_at([&](const Vec3<double>& x) { return flow_at(setup, strengths, k, x); }, s.centre);
      if (s.motion == Motion::free) s.velocity = ambient.velocity;
      if (s.motion != Motion::prescribed) s.angular_velocity = ambient.rotation;
      strengths[k] = {s.force ? *s.force : 6 * pi * (s.velocity - ambient.velocity),
                      8 * pi * (s.angular_velocity - ambient.rotation), (20 * pi / 3) * ambient.strain};
    }
  return strengths;
}

std::vector<UnboundedResult> run_with(Trial& trial, const Unbounded& setup, const std::vector<Strength>& strengths,
                                      const std::string& label, double tolerance, VelocityProfile* profile = nullptr) {
  const double a = setup.radius, viscosity = setup.scheme.viscosity(), unit = setup.speed;
  const std::vector<UnboundedSphere>& spheres = setup.spheres;

  Vec3<double> reach{};
  for (const UnboundedSphere& s : spheres)
    reach = {std::max(reach.x, std::abs(s.centre.x)), std::max(reach.y, std::abs(s.centre.y)),
             std::max(reach.z, std::abs(s.centre.z))};
  const auto cells = [&](double half) { return 2 * int(std::lround(a * (half + 1 + setup.clearance))) + 3; };
  Cells n{cells(reach.x), cells(reach.y), cells(reach.z)};
  Vec3<double> middle = 0.5 * Vec3<double>{n[0] - 1.0, n[1] - 1.0, n[2] - 1.0} + setup.shift;
  if (setup.wall) {
    // The wall lies half a cell above the first row.
    middle.y = 0.5 - a * *setup.wall;
    n[1] = int(std::lround(middle.y + a * (reach.y + 1 + setup.clearance))) + 2;
  }

  // Velocity at a place in cells: inside a sphere its own.
  const Field field = [&](const Vec3<double>& place) {
    const Vec3<double> x = (1 / a) * (place - middle);
    for (const UnboundedSphere& s : spheres) {
      const Vec3<double> arm = x - s.centre;
      if (dot(arm, arm) < 1) return unit * (s.velocity + cross(s.angular_velocity, arm));
    }
    return unit * flow_at(setup, strengths, spheres.size(), x);
  };

  FluidSetup fluid = resolved_box(n, setup.scheme);
  fluid.solid.assign(cell_count(n), 0);
  std::size_t cell = 0;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x)
        fluid.solid[cell++] = x == 0 || y == 0 || z == 0 || x == n[0] - 1 || y == n[1] - 1 || z == n[2] - 1;
  // Places there are counted from the corner of the first cell.
  fluid.solid_velocity_lu = [&](const Vec3<double>& place) { return field(place - Vec3<double>{0.5, 0.5, 0.5}); };

  std::vector<TestSphere> solids;
  for (const UnboundedSphere& s : spheres)
    solids.push_back(
        {.sphere = {middle + a * s.centre, a, unit * s.velocity, (unit / a) * s.angular_velocity}, .motion = s.motion});
  ResolvedFlow flow(trial, fluid, setup.scheme, solids, label);
  flow.fill([&](const Cells& c) {
    if (fluid.solid[cell_number(n, c)]) return CellState{};
    const Vec3<double> place{double(c[0]), double(c[1]), double(c[2])};
    return CellState{1, field(place), strain_rate_of(field, place)};
  });
  flow.advance_to_steady(tolerance, int(std::lround(2 * a * a / viscosity)));

  if (profile)
    for (int y = 1; y < n[1] - 1; ++y) {
      const Cells c{int(std::lround(middle.x)), y, int(std::lround(middle.z))};
      profile->height.push_back((y - middle.y) / a);
      profile->velocity.push_back(flow.velocity(c).x / unit);
    }
  std::vector<UnboundedResult> results;
  for (std::size_t k = 0; k < spheres.size(); ++k) {
    const HydrodynamicLoad& load = flow.load(k);
    const ResolvedSphere& s = flow.sphere(k).sphere;
    results.push_back({(1 / (6 * pi * viscosity * a * unit)) * load.force,
                       (1 / (8 * pi * viscosity * a * a * unit)) * load.torque, (1 / unit) * s.velocity,
                       (a / unit) * s.angular_velocity,
                       (3 / (20 * pi * viscosity * a * a * unit)) * load.complete_stresslet()});
  }
  return results;
}

}  // namespace

std::vector<UnboundedResult> run_unbounded(Trial& trial, const Unbounded& setup, const std::string& label,
                                           double tolerance, VelocityProfile* profile) {
  Unbounded run = setup;
  std::vector<Strength> strengths = strengths_by_reflection(run);
  if (run.spheres.size() > 1 || run.wall) {
    Unbounded coarse = run;
    coarse.scheme = default_scheme(2);
    coarse.radius = 4;
    coarse.shift = {};
    const auto found = run_with(trial, coarse, strengths, label + ", strengths", 2e-3);
    for (std::size_t k = 0; k < found.size(); ++k) {
      const SymTensor3<double> deviator = found[k].stresslet - (trace(found[k].stresslet) / 3) * identity3<double>();
      strengths[k] = {run.spheres[k].force ? *run.spheres[k].force : -6 * pi * found[k].force,
                      -8 * pi * found[k].torque, (20 * pi / 3) * deviator};
      run.spheres[k].velocity = found[k].velocity;
      run.spheres[k].angular_velocity = found[k].angular_velocity;
    }
  }
  return run_with(trial, run, strengths, label, tolerance, profile);
}

}  // namespace stresslet::validation
