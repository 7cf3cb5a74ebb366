/// Suspensions in resolved fluid through the program: the same bytes on any number of threads and after a restart, what
/// the summary says, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "same_results.hpp"
#include "stresslet/simulation/fluid/lattice_checkpoint.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Spheres close enough to touch and to share cells.
constexpr const char* small_resolved_case = R"(fidelity = "resolved"
[suspension]
solid_fraction = 0.4
count = 36
seed = 5
sizes = { law = "monodisperse" }
[contact]
friction = 0.5
[resolution]
cells_per_diameter = 6
[run]
strain = 0.045
average_from = 0.005
threads = 1
[output]
sample_every = 0.01
snapshot_every = 0.02
)";

class ResolvedRun : public ::testing::Test {
 protected:
  const Workplace place_;
  const std::string input_ = place_.write("case.toml", small_resolved_case);

  std::string finished(const std::string& name, const std::vector<std::string>& assignments) {
    const std::string results = place_ / name;
    const Outcome outcome = stresslet(run_arguments(input_, results, assignments));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return results;
  }
  Outcome checked(const std::vector<std::string>& assignments) {
    std::vector<std::string> arguments{"check", input_};
    for (const std::string& argument : settings(assignments)) arguments.push_back(argument);
    return stresslet(arguments);
  }
};

std::vector<double> populations_in(const std::string& folder) {
  const Checkpoint checkpoint = ResultsReader(folder + "/results.h5").checkpoint();
  return read_populations(folder, std::get<std::int64_t>(checkpoint.scalars.at("steps")));
}

TEST_F(ResolvedRun, HasTheSameBytesOnTwoThreads) {
  const std::string one = finished("one", {}), two = finished("two", {"run.threads=2"});
  expect_same_results(two, one);
  EXPECT_TRUE(populations_in(two) == populations_in(one));
}

/// The stop lies between two samples: what spheres carried across the plane so far must not be lost.
TEST_F(ResolvedRun, GoesOnAfterARestartAsIfUnbroken) {
  const std::string whole = finished("whole", {}), broken = finished("broken", {"run.strain=0.026"});
  const Outcome again = stresslet(restart_arguments(broken, {"run.strain=0.045"}));
  ASSERT_EQ(again.code, 0) << again.err;
  expect_same_results(broken, whole);
  EXPECT_TRUE(populations_in(broken) == populations_in(whole));
}

TEST_F(ResolvedRun, GoesOnBetweenWallsAsIfUnbroken) {
  const std::vector<std::string> walls{"flow.boundary=walls", "suspension.solid_fraction=0.35"};
  std::vector<std::string> shorter = walls, threads = walls;
  shorter.emplace_back("run.strain=0.026");
  threads.emplace_back("run.threads=2");
  const std::string whole = finished("whole", walls), broken = finished("broken", shorter);
  const Outcome again = stresslet(restart_arguments(broken, {"run.strain=0.045"}));
  ASSERT_EQ(again.code, 0) << again.err;
  expect_same_results(broken, whole);
  expect_same_results(finished("threads", threads), whole);
  EXPECT_TRUE(populations_in(broken) == populations_in(whole));
}

TEST_F(ResolvedRun, SaysHowWellTheStressCloses) {
  const auto summary = timeless_summary(finished("results", {"run.average_from=0.03", "run.strain=0.1"}));
  EXPECT_LT(std::abs(summary["stress_closure"]["mean"].get<double>()), 0.01);
  EXPECT_GE(summary["stress_closure"]["error"].get<double>(), 0);
  const double viscosity = summary["relative_viscosity"]["mean"];
  EXPECT_NEAR(summary["relative_viscosity_from_dissipation"]["mean"].get<double>() / viscosity, 1, 0.03);
  EXPECT_LT(summary["lowest_density"].get<double>(), 1);
  EXPECT_GT(summary["lowest_density"].get<double>(), 0.9);
  EXPECT_GT(summary["highest_density"].get<double>(), 1);
  EXPECT_LT(summary["highest_density"].get<double>(), 1.1);
}

/// The fluid follows the mean shear flow, more or less in each plane of cells and well on average.
TEST_F(ResolvedRun, KeepsTheVelocityProfileOfTheFluid) {
  const ResultsReader reader(finished("results", {}) + "/results.h5");
  const auto height = reader.profile("fluid_height").values, velocity = reader.profile("fluid_velocity").values;
  ASSERT_EQ(height.size(), velocity.size());
  const double top = height.back() + height.front();
  EXPECT_NEAR(height[1] - height[0], 1.0 / 6, 0.01);
  double slope = 0, squares = 0;
  for (std::size_t k = 0; k < height.size(); ++k) {
    const double y = height[k] - top / 2;
    EXPECT_NEAR(velocity[k], y, 0.2) << k;
    slope += velocity[k] * y;
    squares += y * y;
  }
  EXPECT_NEAR(slope / squares, 1, 0.1);
}

TEST_F(ResolvedRun, CorrectsTheModesOfTheModel) {
  EXPECT_THAT(checked({"model.name=NLM"}).out, HasSubstr("sliding 0, spin 0 cells"));
  EXPECT_THAT(checked({"model.name=CLM"}).out, Not(HasSubstr("sliding 0,")));
  EXPECT_THAT(checked({"model.name=NLM", "flow.boundary=walls"}).out,
              HasSubstr("normal 0.452, sliding 0, spin 0 cells"));
  EXPECT_THAT(checked({"flow.boundary=walls"}).out, HasSubstr("normal 0.452, sliding 0.199, spin 0.013 cells"));
}

TEST_F(ResolvedRun, RefusesWhatTheLatticeCannotHold) {
  const Outcome coarse = checked({"resolution.cells_per_diameter=2.5", "suspension.sizes.law=discrete",
                                  "suspension.sizes.diameters=[1, 0.5]", "suspension.sizes.volume_shares=[0.5, 0.5]"});
  EXPECT_EQ(coarse.code, 2);
  EXPECT_THAT(coarse.err, AllOf(HasSubstr("the smallest particle would be"), HasSubstr("cells across"),
                                HasSubstr("give at least resolution.cells_per_diameter = 4")));
  const Outcome fast = checked({"flow.reynolds=30", "flow.stokes=30"});
  EXPECT_EQ(fast.code, 2);
  EXPECT_THAT(fast.err, AllOf(HasSubstr("the Mach number of the mean flow would be"), HasSubstr("nearest possible")));
}

TEST_F(ResolvedRun, KeepsItsFidelityOnRestart) {
  const std::string results = finished("results", {"run.strain=0.01"});
  const Outcome other = stresslet(restart_arguments(results, {"fidelity=lubricated", "run.strain=0.02"}));
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.err, AllOf(HasSubstr("fidelity cannot be changed by a restart"), HasSubstr("suspension.file")));
}

/// The last state, not the last snapshot, which is that of the start here.
TEST_F(ResolvedRun, StartsFromTheLastStateOfALubricatedRun) {
  const std::string lubricated = finished("lubricated", {"fidelity=lubricated", "run.strain=0.013"});
  const std::string before = content_of(lubricated + "/results.h5");
  std::vector<std::string> arguments =
      restart_arguments(lubricated, {"fidelity=resolved", "run.strain=0.006", "contact.friction=0"});
  const Outcome nowhere = stresslet(arguments);
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("--output"));

  arguments.insert(arguments.end(), {"--output", place_ / "resolved"});
  const Outcome outcome = stresslet(arguments);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(content_of(lubricated + "/results.h5"), before);
  const Checkpoint end = ResultsReader(lubricated + "/results.h5").checkpoint();
  const Snapshot start = ResultsReader(place_ / "resolved/results.h5").snapshot(0);
  EXPECT_EQ(start.strain, 0);
  EXPECT_EQ(start.box.offset, std::get<double>(end.scalars.at("box_offset")));
  EXPECT_GT(start.box.offset, 0.01);
  const auto& id = std::get<std::vector<std::int32_t>>(end.arrays.at("state_id"));
  const auto& y = std::get<std::vector<double>>(end.arrays.at("state_y"));
  ASSERT_EQ(id.size(), 36u);
  for (std::size_t k = 0; k < id.size(); ++k) EXPECT_EQ(start.position[3 * std::size_t(id[k]) + 1], y[k]);
}

TEST_F(ResolvedRun, RestartsInItsOwnFolder) {
  const std::string results = finished("results", {"run.strain=0.01"});
  std::vector<std::string> arguments = restart_arguments(results, {"run.strain=0.02"});
  arguments.insert(arguments.end(), {"--output", place_ / "elsewhere"});
  const Outcome outcome = stresslet(arguments);
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("goes on in the folder of its run"));
  EXPECT_FALSE(std::filesystem::exists(place_ / "elsewhere"));
}

}  // namespace
}  // namespace stresslet
