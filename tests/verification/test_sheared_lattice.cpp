/// A simple cubic lattice of free spheres in simple shear, at frozen strain: viscosity, normal stresses and angular velocity
/// against the Stokes solution (method of fundamental solutions with periodic Stokeslets), for the sphere in the middle of the
/// box, between cells, and cut by the sheared plane.
#include <gtest/gtest.h>

#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/resolved_fluid.hpp"
#include "stresslet/coupling/sphere_update.hpp"

namespace stresslet {
namespace {

struct Rheology {
  double viscosity, N1, N2, spin;
};

/// Solid fraction 0.1 in a box of 17 cells: spheres 9.8 cells across.
Rheology sheared_lattice(double strain, const Vec3<double>& centre) {
  constexpr int edge = 17;
  const double volume = double(edge) * edge * edge, radius = std::cbrt(0.1 * volume * 3 / (4 * pi));
  const double shear_rate = 2e-4;
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.grid.closure[1] = Closure::sheared;
  setup.collision = "TRT";
  setup.rates.relaxation_time = 1.0;
  setup.rates.magic_parameter = 1.0 / 12;
  setup.shear_velocity_lu = shear_rate * edge;
  const double viscosity = kinematic_viscosity_lu(1.0);
  ResolvedFluid fluid(setup, {});
  const double middle = (edge - 1) / 2.0;
  fluid.fill([&](const Cells& c) {
    CellState s;
    s.velocity.x = shear_rate * (c[1] - middle);
    s.strain_rate.xy = 0.5 * shear_rate;
    return s;
  });
  const double mass = 4 * pi / 3 * std::pow(radius, 3), inertia = 0.4 * mass * radius * radius;
  std::vector<ResolvedSphere> spheres{{centre, radius, {shear_rate * (centre.y - middle), 0, 0}, {0, 0, -shear_rate / 2}}};
  ThreadTeam team(1);
  HydrodynamicLoad load;
  team.run([&](Member& member) {
    for (int n = 0; n < 3000; ++n) {
      // The sphere stays where it is, and so do the images: only the flow settles.
      fluid.lattice().shear_offset = fluid.lattice().departure_offset = strain * edge;
      fluid.prepare(member, spheres);
      const auto now = settled_velocities(fluid.exchange(0), mass, inertia,
                                          {spheres[0].velocity, spheres[0].angular_velocity}, {}, {});
      spheres[0].velocity = now.velocity;
      spheres[0].angular_velocity = now.angular_velocity;
      load = load_on_sphere(fluid.exchange(0), now.velocity, now.angular_velocity);
      fluid.sweep(member, spheres);
    }
  });
  // The surface force of the particle on the fluid's behalf: tension positive, the opposite of the fluid's force on it.
  const SymTensor3<double> stress = (1 / (volume * viscosity * shear_rate)) * load.stresslet;
  return {1 + stress.xy, stress.xx - stress.yy, stress.yy - stress.zz, spheres[0].angular_velocity.z / shear_rate};
}

TEST(ShearedLattice, PrintsForNow) {
  for (const double strain : {0.0, 0.125, 0.25, 0.5})
    for (const Vec3<double>& centre : {Vec3<double>{8, 8, 8}, Vec3<double>{8.5, 8.4, 7.7}, Vec3<double>{3, 16.4, 8}}) {
      const Rheology r = sheared_lattice(strain, centre);
      std::printf("strain %.3f: eta %.5f N1 %.5f N2 %.5f spin %.5f\n", strain, r.viscosity, r.N1, r.N2, r.spin);
    }
}

}  // namespace
}  // namespace stresslet
