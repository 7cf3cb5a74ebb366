// Solid cells: the walls they make, and bits that depend on no blocks.
#include <gtest/gtest.h>

#include "../boundary_cases.hpp"

namespace stresslet {
namespace {

using namespace testing;

TEST(SolidCells, MakeTheSameWallsAsOpenFaces) {
  for (const StencilOf& stencil : stencils())
    for (const bool single : {false, true})
      for (const int steps : {8, 9}) {
        if (single && stencil.name != "D3Q19") continue;
        const bool flat = stencil.dimensions == 2;
        const int nz = flat ? 1 : 3;
        const auto state = [&](const Cells& c) { return swirl(c, flat); };
        FluidSetup open = between_faces(stencil, 1, "half-way", {5, 4, nz});
        open.single_precision = single, open.forcing = "guo";
        SmallFluid walls(open);
        walls->set_force_density({1e-4, 2e-4, 0});
        walls.start(state);
        walls.advance(steps);

        FluidSetup closed = fluid_setup(stencil.name, {5, 6, nz});
        closed.single_precision = single, closed.forcing = "guo", closed.grid.blocks = {1, 2, 1};
        for (int z = 0; z < nz; ++z)
          for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 5; ++x) closed.solid.push_back(y == 0 || y == 5);
        SmallFluid solid(closed);
        solid->set_force_density({1e-4, 2e-4, 0});
        solid.start([&](const Cells& c) { return state({c[0], c[1] - 1, c[2]}); });
        solid.advance(steps);
        walls.for_each([&](const Cells& c, const CellState& expected) {
          const CellState found = solid.at({c[0], c[1] + 1, c[2]});
          EXPECT_EQ(found.density, expected.density);
          EXPECT_EQ(found.velocity, expected.velocity);
          EXPECT_EQ(found.strain_rate, expected.strain_rate);
        });
        const auto a = walls.totals(), b = solid.totals();
        EXPECT_EQ(a.mass_deviation, b.mass_deviation);
        EXPECT_EQ(a.momentum, b.momentum);
        EXPECT_EQ(a.lowest_density, b.lowest_density);
        EXPECT_EQ(solid.at({2, 0, 0}).density, 1);
        EXPECT_EQ(solid.at({2, 5, 0}).velocity, Vec3<double>{});
      }
}

TEST(SolidCells, GiveTheSameBitsInAShearedBoxOfAnyBlocks) {
  const auto run = [](const Cells& blocks) {
    FluidSetup setup = fluid_setup("D3Q19", {7, 6, 4}, {Closure::periodic, Closure::sheared, Closure::periodic});
    setup.grid.blocks = blocks, setup.shear_velocity_lu = 0.05, setup.forcing = "guo";
    setup.solid.resize(7 * 6 * 4);
    for (const std::size_t cell : {15, 16, 23, 70, 111, 113, 135}) setup.solid[cell] = 1;
    SmallFluid fluid(setup, blocks[1]);
    fluid->set_force_density({1e-4, -2e-4, 3e-4});
    fluid.start([](const Cells& c) { return swirl(c, false); });
    const double before = fluid.totals().mass_deviation;
    fluid.advance(9);
    EXPECT_NEAR(fluid.totals().mass_deviation, before, 1e-14);
    return fluid.populations();
  };
  const std::vector<double> expected = run({1, 1, 1});
  EXPECT_EQ(run({2, 2, 2}), expected);
  EXPECT_EQ(run({3, 1, 1}), expected);
}

}  // namespace
}  // namespace stresslet
