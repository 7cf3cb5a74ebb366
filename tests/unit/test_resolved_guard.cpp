/// What ends a resolved run: a cell or a sphere that the lattice cannot follow is named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "../numerical_failure.hpp"
#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/monitor.hpp"
#include "stresslet/simulation/plan.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/step.hpp"

namespace stresslet {
namespace {

using ::testing::AllOf;
using testing::failure_of;
using ::testing::HasSubstr;

class ResolvedGuard : public ::testing::Test {
 protected:
  const Case settled_ = std::get<Case>(
      read_any_case_text("fidelity = \"resolved\"\n", "guard",
                         {"suspension.solid_fraction=0.1", "suspension.count=9", "suspension.sizes.law=monodisperse",
                          "resolution.cells_per_diameter=5", "run.strain=1"}));
  const Plan plan_ = make_plan(settled_);
  ThreadTeam team_{1};
  Suspension s_ = make_suspension(settled_, plan_, {});

  void SetUp() override { start(s_, team_); }

  /// Adds to the population at rest of cell (3, 4, 5), and looks.
  std::string complaint_with(double added) {
    const Cells& n = plan_.resolved->cells;
    std::vector<double> populations = s_.resolved->populations(team_);
    populations[3 + std::size_t(n[0]) * (4 + std::size_t(n[1]) * 5)] += added;
    s_.resolved->restore(team_, populations, s_.steps, s_.box.offset);
    sample(s_, team_);
    return failure_of([&] { check_fluid(s_); });
  }
};

TEST_F(ResolvedGuard, IsSilentOnASoundFluid) {
  EXPECT_EQ(complaint_with(0.25), "");
  EXPECT_EQ(complaint_with(-0.5), "");
  EXPECT_EQ(failure_of([&] { check_sphere_speeds(s_); }), "");
}

TEST_F(ResolvedGuard, NamesTheCell) {
  EXPECT_THAT(complaint_with(0.4),
              AllOf(HasSubstr("the density of cell (3, 4, 5) is 1.4"), HasSubstr("\n  why: "), HasSubstr("\n  fix: ")));
  EXPECT_THAT(complaint_with(-0.8), HasSubstr("the density of cell (3, 4, 5) is 0.6"));
  EXPECT_THAT(complaint_with(std::numeric_limits<double>::quiet_NaN()),
              HasSubstr("cell (3, 4, 5) holds numbers that are not finite"));
}

TEST_F(ResolvedGuard, NamesTheSphere) {
  // Mach 0.29 and 0.31; speed of sound 1/sqrt(3) cells a step.
  const double sound = s_.resolved->setup().cell / (std::sqrt(3.0) * s_.time.step);
  s_.state.set_velocity(2, {0.29 * sound, 0, 0});
  EXPECT_EQ(failure_of([&] { check_sphere_speeds(s_); }), "");
  s_.state.set_velocity(2, {0, 0.31 * sound, 0});
  EXPECT_THAT(failure_of([&] { check_sphere_speeds(s_); }),
              AllOf(HasSubstr("particle 2 moves at Mach number 0.31"), HasSubstr("\n  fix: ")));
}

}  // namespace
}  // namespace stresslet
