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
  return {field(x) + (1.0 / 6) * laplacian(field, x),
          0.5 * Vec3<double>{dy.z - dz.y, dz.x - dx.z, dx.y - dy.x},
          strain(x) + 0.1 * laplacian(strain, x)};
}

/// Exact to some power of a/(distance of the spheres). Sets the velocities that are free.
std::vector<Strength> strengths_by_reflection(std::vector<UnboundedSphere>& spheres, const Field& background) {
  std::vector<Strength> strengths(spheres.size());
  for (int round = 0; round < 25; ++round)
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const Field others = [&](const Vec3<double>& x) {
        Vec3<double> u = background(x);
        for (std::size_t j = 0; j < spheres.size(); ++j)
          if (j != k) u += disturbance(x - spheres[j].centre, 1, 1, strengths[j]);
        return u;
      };
      UnboundedSphere& s = spheres[k];
      const Ambient ambient = ambient_at(others, s.centre);
      if (s.motion == Motion::free) s.velocity = ambient.velocity;
      if (s.motion != Motion::prescribed) s.angular_velocity = ambient.rotation;
      strengths[k] = {s.force ? *s.force : 6 * pi * (s.velocity - ambient.velocity),
                      8 * pi * (s.angular_velocity - ambient.rotation), (20 * pi / 3) * ambient.strain};
    }
  return strengths;
}

Vec3<double> background(const Unbounded& setup, const Vec3<double>& x) {
  return Vec3<double>{setup.shear_rate * x.y, 0, 0} + setup.strain * x;
}

std::vector<UnboundedResult> run_with(Trial& trial, const Unbounded& setup, const std::vector<Strength>& strengths,
                                      const std::string& label, double tolerance) {
  const double a = setup.radius, viscosity = setup.scheme.viscosity(), unit = setup.speed;
  const std::vector<UnboundedSphere>& spheres = setup.spheres;

  Vec3<double> reach{};
  for (const UnboundedSphere& s : spheres)
    reach = {std::max(reach.x, std::abs(s.centre.x)), std::max(reach.y, std::abs(s.centre.y)),
             std::max(reach.z, std::abs(s.centre.z))};
  const auto cells = [&](double half) { return 2 * int(std::lround(a * (half + 1 + setup.clearance))) + 3; };
  const Cells n{cells(reach.x), cells(reach.y), cells(reach.z)};
  const Vec3<double> middle = 0.5 * Vec3<double>{n[0] - 1.0, n[1] - 1.0, n[2] - 1.0} + setup.shift;

  // Velocity at a place in cells: inside a sphere its own.
  const Field field = [&](const Vec3<double>& place) {
    const Vec3<double> x = (1 / a) * (place - middle);
    Vec3<double> u = background(setup, x);
    for (std::size_t k = 0; k < spheres.size(); ++k) {
      const Vec3<double> arm = x - spheres[k].centre;
      if (dot(arm, arm) < 1) return unit * (spheres[k].velocity + cross(spheres[k].angular_velocity, arm));
      u += disturbance(arm, 1, 1, strengths[k]);
    }
    return unit * u;
  };

  FluidSetup fluid = resolved_box(n, setup.scheme);
  fluid.solid.assign(std::size_t(n[0]) * std::size_t(n[1]) * std::size_t(n[2]), 0);
  std::size_t cell = 0;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x)
        fluid.solid[cell++] =
            x == 0 || y == 0 || z == 0 || x == n[0] - 1 || y == n[1] - 1 || z == n[2] - 1;
  // Places there are counted from the corner of the first cell.
  fluid.solid_velocity_lu = [&](const Vec3<double>& place) { return field(place - Vec3<double>{0.5, 0.5, 0.5}); };

  std::vector<TestSphere> solids;
  for (const UnboundedSphere& s : spheres)
    solids.push_back({.sphere = {middle + a * s.centre, a, unit * s.velocity, (unit / a) * s.angular_velocity},
                      .motion = s.motion});
  ResolvedFlow flow(trial, fluid, setup.scheme, solids, label);
  flow.fill([&](const Cells& c) {
    if (fluid.solid[std::size_t(c[0]) + std::size_t(n[0]) * (std::size_t(c[1]) + std::size_t(n[1]) * std::size_t(c[2]))])
      return CellState{};
    const Vec3<double> place{double(c[0]), double(c[1]), double(c[2])};
    return CellState{1, field(place), strain_rate_of(field, place)};
  });
  flow.advance_to_steady(tolerance, int(std::lround(2 * a * a / viscosity)));

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
                                           double tolerance) {
  Unbounded run = setup;
  std::vector<Strength> strengths =
      strengths_by_reflection(run.spheres, [&](const Vec3<double>& x) { return background(setup, x); });
  if (run.spheres.size() > 1) {
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
  return run_with(trial, run, strengths, label, tolerance);
}

}  // namespace stresslet::validation
