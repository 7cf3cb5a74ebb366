/// What spheres cover is found anew where something moved, and only there.
#include <gtest/gtest.h>

#include <map>

#include "stresslet/coupling/covered_runs.hpp"

namespace stresslet {
namespace {

using CellDrags = std::map<std::array<int, 3>, double>;

/// Drags by global cell, of all runs.
CellDrags drags(CoveredRuns<double>& covered) {
  covered.fill_drags({0, covered.runs().size()});
  CellDrags found;
  for (const CoveredRun& run : covered.runs())
    for (int k = 0; k < run.packs * CoveredRuns<double>::width; ++k)
      if (covered.drag(run)[k] > 0) found[{run.global_x + k, run.global_y, run.global_z}] += covered.drag(run)[k];
  return found;
}

class CoveredRunsOf : public ::testing::Test {
 protected:
  CellDrags placed(CoveredRuns<double>& covered, double x, double offset = 0) {
    const std::vector<ResolvedSphere> spheres{{{x, 9.3, 10.1}, 4.2, {}, {}}, {{12, 18.9, 4}, 3, {}, {}}};
    team_.run([&](Member& member) { covered.place(member, spheres, offset, 0.01); });
    return drags(covered);
  }
  CellDrags anew(double x, double offset = 0) {
    CoveredRuns<double> covered(grid(), {});
    return placed(covered, x, offset);
  }
  static Grid grid() {
    Grid grid;
    grid.size = {24, 20, 22};
    grid.closure[1] = Closure::sheared;
    return grid;
  }
  ThreadTeam team_{2};
};

TEST_F(CoveredRunsOf, SpheresAtRestAndMovingAgain) {
  CoveredRuns<double> covered(grid(), {});
  const CellDrags here = placed(covered, 8.2);
  EXPECT_EQ(here, anew(8.2));
  EXPECT_EQ(placed(covered, 8.2), here);
  const CellDrags there = placed(covered, 8.3);
  EXPECT_EQ(there, anew(8.3));
  EXPECT_NE(there, here);
  EXPECT_EQ(placed(covered, 8.2), here);
}

TEST_F(CoveredRunsOf, SpheresAtRestUnderAMovingImage) {
  CoveredRuns<double> covered(grid(), {});
  const CellDrags before = placed(covered, 8.2, 1.5), after = placed(covered, 8.2, 1.6);
  EXPECT_EQ(after, anew(8.2, 1.6));
  EXPECT_NE(after, before);
}

}  // namespace
}  // namespace stresslet
