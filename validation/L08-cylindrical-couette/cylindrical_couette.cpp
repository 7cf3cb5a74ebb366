/// Flow between a cylinder of radius R1 that turns with Omega and a fixed one of radius R2:
///   u_theta = Omega R1^2 / (R2^2 - R1^2) (R2^2 / r - r),   torque per length T = 4 pi mu Omega R1^2 R2^2 / (R2^2 -
///   R1^2)
/// (Landau & Lifshitz, Fluid Mechanics, section 18). The cylinders are voxels, every cell whose centre lies in them,
/// with half-way walls on the stairs: the surface is wrong by up to half a cell, so the flow is first order with
/// scatter from grid to grid, and that is what the tolerances say. The torque is read from the shear stress of the
/// populations, -2 pi r^2 2 mu S_r_theta, over the fluid away from the stairs.
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/flow.hpp"

namespace stresslet::validation {

namespace {

constexpr double surface_speed = 0.02;

struct Cylinders {
  double inner, outer;  // radii in cells
  int cells;            // of the box, a side

  Vec3<double> from_axis(const Vec3<double>& place) const { return {place.x - 0.5 * cells, place.y - 0.5 * cells, 0}; }
  Vec3<double> centre_of(const Cells& c) const { return from_axis({c[0] + 0.5, c[1] + 0.5, 0}); }
  bool is_solid(const Cells& c) const {
    const double r = norm(centre_of(c));
    return r < inner || r > outer;
  }
  double constant() const {  // Omega R1^2 R2^2 / (R2^2 - R1^2)
    return surface_speed * inner * outer * outer / (outer * outer - inner * inner);
  }
  double velocity(double r) const { return constant() * (1 / r - r / (outer * outer)); }
};

struct Found {
  double error, torque;  // relative L2 error of u_theta; torque over exact
  std::vector<double> radius, velocity, exact;
};

Found measure(Trial& trial, const std::string& collision, double relaxation_time, double inner) {
  const Cylinders cylinders{inner, 2 * inner, int(4 * inner) + 4};
  const int n = cylinders.cells;
  FluidSetup setup = periodic_box("D2Q9", {n, n, 1}, collision, relaxation_time);
  setup.solid.resize(std::size_t(n * n));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) setup.solid[std::size_t(x + n * y)] = cylinders.is_solid({x, y, 0});
  setup.solid_velocity_lu = [&](const Vec3<double>& place) {
    const Vec3<double> r = cylinders.from_axis(place);
    return norm(r) < 1.5 * inner ? surface_speed / inner * Vec3<double>{-r.y, r.x, 0} : Vec3<double>{};
  };
  Flow flow(trial, setup, fmt::format("L8, {}, inner radius {} cells", collision, inner));
  flow.rest();
  const double time = inner * inner / (pi * pi * kinematic_viscosity_lu(relaxation_time));
  flow.advance_to_steady(1e-7, int(time), int(100 * time));

  const std::vector<CellState> states = flow.states();
  Found found{0, 0, {}, {}, {}};
  int counted = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      if (cylinders.is_solid({x, y, 0})) continue;
      const CellState& s = states[std::size_t(x + n * y)];
      const Vec3<double> at = cylinders.centre_of({x, y, 0});
      const double r = norm(at), cosine = at.x / r, sine = at.y / r;
      found.radius.push_back(r / inner);
      found.velocity.push_back((s.velocity.y * cosine - s.velocity.x * sine) / surface_speed);
      found.exact.push_back(cylinders.velocity(r) / surface_speed);
      if (r < inner + 2 || r > 2 * inner - 2) continue;
      const double shear =
          (s.strain_rate.yy - s.strain_rate.xx) * sine * cosine + s.strain_rate.xy * (cosine * cosine - sine * sine);
      found.torque += -shear * r * r / cylinders.constant();
      ++counted;
    }
  found.torque /= counted;
  found.error = relative_l2_error(found.velocity, found.exact);
  return found;
}

}  // namespace

void cylindrical_couette(Trial& trial) {
  const std::vector<int> sizes = trial.choose<std::vector<int>>({8, 16, 32}, {5, 10, 20});
  const double relaxation_time = 0.8;
  trial.parameter("inner radius, cells", double(sizes.back()));
  trial.parameter("outer over inner radius", 2.0);
  trial.parameter("relaxation time", relaxation_time);
  const std::string source = "closed form";
  std::vector<double> errors;
  for (const int inner : sizes) {
    Found found = measure(trial, "TRT", relaxation_time, inner);
    errors.push_back(found.error);
    if (inner != sizes.back()) continue;
    trial.row("TRT: velocity, relative L2 error", found.error, {0, source}, absolute(trial.choose(0.02, 0.03)));
    trial.row("TRT: torque over exact", found.torque, {1, source}, relative(trial.choose(0.02, 0.04)));
    trial.table({"profile",
                 {{"r", "R1", ""}, {"velocity", "Omega R1", ""}, {"exact", "Omega R1", ""}},
                 {found.radius, found.velocity, found.exact}});
  }
  trial.row(fmt::format("order of velocity, {} to {} cells", sizes.front(), sizes.back()),
            observed_order(sizes.front(), errors.front(), sizes.back(), errors.back()), {1, "voxel surface"},
            {false, -0.5, 0.8});
  for (const double tau : {0.55, 1.5}) {
    const Found found = measure(trial, "TRT", tau, sizes[1]);
    trial.row(fmt::format("TRT, tau {}, {} cells: torque over that at tau 0.8", tau, sizes[1]),
              found.torque / measure(trial, "TRT", relaxation_time, sizes[1]).torque,
              {1, "Stokes flow at fixed Lambda"}, relative(1e-3));
  }
}

}  // namespace stresslet::validation
