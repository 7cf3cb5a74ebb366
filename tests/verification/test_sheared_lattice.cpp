/// A simple cubic lattice of free spheres in simple shear, at frozen strain: viscosity, normal stresses and angular
/// velocity against the Stokes solution (method of fundamental solutions with periodic Stokeslets), for the sphere in
/// the middle of the box, between cells, and cut by the sheared plane.
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
  const double shear_rate = 2e-5;  // Reynolds number 0.01: inertia adds 1e-4 to N1
  FluidSetup setup;
  setup.grid.size = {edge, edge, edge};
  setup.grid.closure[1] = Closure::sheared;
  setup.collision = "TRT";
  setup.rates.relaxation_time = 1.0;
  setup.rates.magic_parameter = 1.0 / 12;
  setup.shear_velocity_lu = shear_rate * edge;
  const double viscosity = kinematic_viscosity_lu(1.0);
  ResolvedFluidOf<double> fluid(setup, {});
  const double middle = (edge - 1) / 2.0;
  ThreadTeam team(1);
  fluid.initialise(team, [&](const Cells& c) {
    CellState s;
    s.velocity.x = shear_rate * (c[1] - middle);
    s.strain_rate.xy = 0.5 * shear_rate;
    return s;
  });
  const double mass = 4 * pi / 3 * std::pow(radius, 3), inertia = 0.4 * mass * radius * radius;
  std::vector<ResolvedSphere> spheres{
      {centre, radius, {shear_rate * (centre.y - middle), 0, 0}, {0, 0, -shear_rate / 2}}};
  SphereUpdate update;
  HydrodynamicLoad load;
  team.run([&](Member& member) {
    for (int n = 0; n < 3000; ++n) {
      // The sphere stays where it is, and so do the images: only the flow settles.
      fluid.lattice().shear_offset = fluid.lattice().departure_offset = strain * edge;
      fluid.prepare(member, spheres);
      update.settle(
          spheres, {{mass, inertia}}, {}, [&](std::size_t k) -> const auto& { return fluid.exchange(k); });
      load = load_on_sphere(fluid.exchange(0), spheres[0].velocity, spheres[0].angular_velocity);
      fluid.sweep(member, spheres);
    }
  });
  const SymTensor3<double> stress = (1 / (volume * viscosity * shear_rate)) * load.stresslet;
  return {1 + stress.xy, stress.xx - stress.yy, stress.yy - stress.zz, spheres[0].angular_velocity.z / shear_rate};
}

struct Exact {
  double strain, viscosity, N1, N2, spin;
};

void expect_near(const Rheology& found, const Exact& exact) {
  EXPECT_NEAR(found.viscosity / exact.viscosity, 1, 0.003);
  EXPECT_NEAR(found.spin / exact.spin, 1, 0.012);
  // At the mirror points of the strain both vanish; elsewhere 3 %.
  EXPECT_NEAR(found.N1, exact.N1, exact.N1 == 0 ? 5e-4 : 0.03 * std::abs(exact.N1));
  EXPECT_NEAR(found.N2, exact.N2, exact.N2 == 0 ? 5e-4 : 0.03 * std::abs(exact.N2));
}

constexpr Exact aligned{0, 1.24142, 0, 0, -0.5}, eighth{0.125, 1.24586, -0.02641, 0.01545, -0.49783},
    quarter{0.25, 1.25616, -0.03634, 0.02127, -0.49272}, staggered{0.5, 1.26973, 0, 0, -0.48577};

TEST(ShearedLattice, CutByTheShearedPlane) { expect_near(sheared_lattice(0.25, {3, 16.4, 8}), quarter); }

TEST(LongShearedLattice, AnywhereAtAnyStrain) {
  for (const Exact& exact : {aligned, eighth, quarter, staggered})
    for (const Vec3<double>& centre : {Vec3<double>{8, 8, 8}, Vec3<double>{8.5, 8.4, 7.7}, Vec3<double>{3, 16.4, 8}}) {
      SCOPED_TRACE(exact.strain);
      expect_near(sheared_lattice(exact.strain, centre), exact);
    }
}

}  // namespace
}  // namespace stresslet
