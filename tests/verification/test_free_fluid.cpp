/// The fluid that no sphere touches, plane by plane: how many cells, and how fast. A cell is free where the nearest
/// point of its cube lies outside every sphere, found here by brute force, but for cells that one only just touches;
/// with a weight that draws spheres as they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stresslet/coupling/resolved_fluid.hpp"

namespace stresslet {
namespace {

const Cells size{18, 15, 16};
const std::vector<ResolvedSphere> spheres{{{4.2, 6.1, 6.7}, 3.3}, {{12.6, 14.4, 9.5}, 4.1}};

double distance_across(double centre, int cell, int length) {
  double away = std::abs(centre - cell);
  away = std::min(away, length - away);
  return std::max(0.0, away - 0.5);
}

bool is_free(int x, int y, int z, double beyond) {
  return std::ranges::none_of(spheres, [&](const ResolvedSphere& s) {
    return std::hypot(distance_across(s.centre.x, x, size[0]), distance_across(s.centre.y, y, size[1]),
                      distance_across(s.centre.z, z, size[2])) < s.radius + beyond;
  });
}

TEST(FreeFluid, IsCountedPlaneByPlaneInAnyNumberOfBlocks) {
  const auto velocity = [](int y) { return 1e-3 * std::sin(0.7 * y); };
  for (const Cells& blocks : {Cells{1, 1, 1}, Cells{2, 3, 2}}) {
    FluidSetup setup;
    setup.grid.size = size;
    setup.grid.blocks = blocks;
    setup.collision = "TRT";
    setup.rates.relaxation_time = 1;
    ResolvedFluidOf<double> fluid(setup, {"superposition", {.fraction = "exact", .weight = "linear"}});
    ThreadTeam team(1);
    fluid.initialise(team, [&](const Cells& c) {
      CellState s;
      s.velocity = {velocity(c[1]), 1e-3 * std::cos(c[0]), 0};
      return s;
    });
    std::vector<FreeFluid> planes;
    const FluidEnergy whole = fluid.energy(team, spheres, planes);
    ASSERT_EQ(planes.size(), std::size_t(size[1]));
    double all = 0;
    for (int y = 0; y < size[1]; ++y) {
      int fewest = 0, most = 0;
      for (int z = 0; z < size[2]; ++z)
        for (int x = 0; x < size[0]; ++x) {
          fewest += is_free(x, y, z, 0.01);
          most += is_free(x, y, z, -0.01);
        }
      const FreeFluid& plane = planes[std::size_t(y)];
      EXPECT_GE(plane.cells, fewest) << y;
      EXPECT_LE(plane.cells, most) << y;
      EXPECT_LE(most - fewest, 6) << y;
      EXPECT_NEAR(plane.velocity / plane.cells, velocity(y), 1e-12) << y;
      all += plane.cells;
    }
    EXPECT_EQ(whole.free.cells, all);
    EXPECT_LT(all, size[0] * size[1] * size[2]);
  }
}

}  // namespace
}  // namespace stresslet
