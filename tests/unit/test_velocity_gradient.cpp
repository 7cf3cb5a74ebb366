/// Velocity gradients from neighbours: exact for parabolas beside walls and openings, for shear across the sheared
/// face.
#include <gtest/gtest.h>

#include "stresslet/simulation/fluid/flow_field.hpp"

namespace stresslet {
namespace {

TEST(Derivative, IsExactForParabolas) {
  const auto f = [](double x) { return Vec3<double>{2 + 3 * x - 5 * x * x, x, 1}; };
  for (const auto& [a, b] : {std::pair{-1.0, 1.0}, {-0.5, 1.0}, {-1.0, 0.5}, {-0.5, 0.5}, {1.0, 2.0}, {1.0, 1.5}}) {
    const Vec3<double> slope = derivative(f(0), {a, f(a)}, {b, f(b)});
    EXPECT_NEAR(slope.x, 3, 1e-14);
    EXPECT_NEAR(slope.y, 1, 1e-14);
    EXPECT_NEAR(slope.z, 0, 1e-14);
  }
}

/// The field of a fluid filled with these velocities.
template <class Velocity>
FlowField field_of(const FluidSetup& setup, double offset, Velocity&& velocity) {
  ThreadTeam team(1);
  const auto fluid = Fluid::make(setup);
  fluid->initialise(team, [&](const Cells& c) {
    CellState state;
    state.velocity = velocity(c[0] + 0.5, c[1] + 0.5);
    return state;
  });
  fluid->set_shear_offset(offset);
  FlowField field(setup);
  field.measure(*fluid, team);
  return field;
}

/// Between a wall at rest below and a solid layer from y = 7 on: u_x = c y (7 - y), du_x/dy = c (7 - 2 y) everywhere.
TEST(StrainRateFromVelocities, OfAParabolaBetweenWallAndSolid) {
  FluidSetup setup;
  setup.stencil = "D2Q9";
  setup.grid.size = {3, 9, 1};
  setup.grid.closure[1] = Closure::open;
  setup.solid.assign(27, 0);
  for (int k = 21; k < 27; ++k) setup.solid[std::size_t(k)] = 1;
  const double c = 1e-4;
  const FlowField field = field_of(setup, 0, [&](double, double y) { return Vec3<double>{c * y * (7 - y), 0, 0}; });
  for (int y = 0; y < 7; ++y) {
    const SymTensor3<double> s = field.strain_rate_from_velocities({1, y, 0});
    EXPECT_NEAR(s.xy, 0.5 * c * (7 - 2 * (y + 0.5)), 1e-15) << y;
    EXPECT_NEAR(s.xx, 0, 1e-15);
    EXPECT_NEAR(square_sum(s), 2 * s.xy * s.xy, 1e-20);
  }
}

/// A linear profile goes on across the sheared face at any offset; a wave along x is met where the image has carried
/// it.
TEST(StrainRateFromVelocities, AcrossTheShearedFace) {
  FluidSetup setup;
  setup.stencil = "D2Q9";
  setup.grid.size = {64, 8, 1};
  setup.grid.closure[1] = Closure::sheared;
  setup.shear_velocity_lu = 0.008;
  const double k = 2 * 3.14159265358979323846 / 64, offset = 13.3, wave = 1e-3;
  // In coordinates of the sheared box: x - offset y / 8 is periodic in both directions.
  const FlowField field = field_of(setup, offset, [&](double x, double y) {
    return Vec3<double>{0.001 * (y - 4), wave * std::sin(k * (x - offset * y / 8)), 0};
  });
  for (int y : {0, 7})
    for (int x = 0; x < 64; ++x) {
      const SymTensor3<double> s = field.strain_rate_from_velocities({x, y, 0});
      const double slope = wave * k * std::cos(k * (x + 0.5 - offset * (y + 0.5) / 8));
      // Central differences of a wave: sin(k h)/(k h), and the interpolation of fourth order.
      EXPECT_NEAR(s.yy, -offset / 8 * slope, 0.01 * wave * k * offset / 8);
      EXPECT_NEAR(s.xy, 0.0005 + 0.5 * slope, 0.002 * wave * k);
    }
}

}  // namespace
}  // namespace stresslet
