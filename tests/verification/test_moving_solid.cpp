/// Solid cells whose surface moves: a layer of them is a moving half-way wall, exact for plane Couette flow.
#include <gtest/gtest.h>

#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

TEST(MovingSolid, LayerDrivesALinearProfileAtAnyDivision) {
  for (const std::string& stencil : Stencils::names())
    for (const Cells& blocks : {Cells{1, 1, 1}, Cells{2, 3, 1}}) {
      const int nx = 4, ny = 12, nz = stencil == "D2Q9" ? 1 : 4;
      FluidSetup setup;
      setup.stencil = stencil;
      setup.grid.size = {nx, ny, nz};
      setup.grid.blocks = blocks;
      setup.rates.relaxation_time = 2;
      setup.solid.assign(std::size_t(nx * ny * nz), 0);
      for (int z = 0; z < nz; ++z)
        for (int x = 0; x < nx; ++x) setup.solid[std::size_t(x + nx * (0 + ny * z))] = 1;
      // One layer of solid cells: its upper surface moves one way, its lower one, met across the periodic faces, the
      // other way.
      setup.solid_velocity_lu = [](const Vec3<double>& at) {
        return at.y > 0.5 ? Vec3<double>{-0.01, 0, 0} : Vec3<double>{0.02, 0, 0};
      };
      ThreadTeam team(1);
      const auto fluid = Fluid::make(setup);
      fluid->initialise(team, [](const Cells&) { return CellState{}; });
      for (const int steps : {800, 1}) {
        fluid->advance(team, steps);
        fluid->measure(team, {0, 1, 0}, {nx - 1, ny - 1, nz - 1}, {1, 1, 1}, [&](const Cells& c, const CellState& s) {
          EXPECT_NEAR(s.velocity.x, -0.01 + 0.03 * (c[1] - 0.5) / (ny - 1), 1e-11) << stencil << " y " << c[1];
          EXPECT_NEAR(s.density, 1, 1e-11);
        });
      }
    }
}

}  // namespace
}  // namespace stresslet
