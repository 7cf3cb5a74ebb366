/// A run from the outside: the files it leaves, what stands in them, and every model, law, boundary and scheme.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "../program.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"
#include "stresslet/io/results_file.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// Runs the small case with changes and returns its summary.
Json summary_of(const Workplace& place, const std::string& name, const std::vector<std::string>& assignments) {
  const Outcome outcome =
      stresslet(run_arguments(place.write(name + ".toml", small_case()), place / name, assignments));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return Json::parse(content_of(place / name + "/summary.json"));
}

void expect_finite_numbers(const Json& value, const std::string& path = "") {
  if (value.is_object())
    for (const auto& [key, entry] : value.items()) expect_finite_numbers(entry, path + "/" + key);
  else
    EXPECT_FALSE(value.is_null()) << path << " is not a finite number";  // JSON writes NaN and infinity as null
}

void expect_finite_series(const std::string& folder) {
  const ResultsReader results(folder + "/results.h5");
  for (const Column& column : results.columns())
    for (const double value : results.series(column.name)) ASSERT_TRUE(std::isfinite(value)) << column.name;
}

TEST(Run, LeavesAllFilesWithAllKeys) {
  const Workplace place;
  const Json summary = summary_of(place, "results", {});
  for (const char* file : {"results.h5", "series.csv", "summary.json", "particles.xyz", "particles.xdmf"})
    EXPECT_GT(content_of(place / "results/" + file).size(), 100u) << file;

  for (const char* key : {"solid_fraction", "particles", "strain", "velocity_slope", "largest_overlap", "wall_seconds",
                          "particle_steps_per_second"})
    EXPECT_TRUE(summary.at(key).is_number()) << key;
  for (const char* key :
       {"relative_viscosity", "relative_viscosity_from_dissipation", "N1", "N2", "contacts_per_particle"})
    EXPECT_TRUE(summary.at(key).at("mean").is_number() && summary.at(key).at("error").is_number()) << key;
  for (const char* part : {"contact", "lubrication_normal", "lubrication_tangential", "lubrication_rotational",
                           "stresslet", "reynolds", "acceleration"})
    EXPECT_TRUE(summary.at("contribution").at(part).at("mean").is_number()) << part;

  EXPECT_EQ(summary["status"], "finished");
  EXPECT_EQ(summary["particles"], 80);
  EXPECT_NEAR(summary["solid_fraction"].get<double>(), 0.45, 1e-12);
  EXPECT_NEAR(summary["strain"].get<double>(), 0.02, 1e-12);
  EXPECT_NEAR(summary["contribution"]["stresslet"]["mean"].get<double>(), 2.5 * 0.45, 1e-12);
  EXPECT_GT(summary["wall_seconds"].get<double>(), 0.0);
  EXPECT_GT(summary["particle_steps_per_second"].get<double>(), 0.0);
  const auto& share = summary["time_share"];
  EXPECT_NEAR(share["particles"].get<double>() + share["analysis"].get<double>() + share["output"].get<double>(), 1,
              1e-12);
  expect_finite_numbers(summary);
}

TEST(Run, PartsAddUpToTheViscosity) {
  const Workplace place;
  const Json summary = summary_of(place, "results", {});
  double sum = 1;
  for (const auto& [part, value] : summary["contribution"].items()) sum += value["mean"].get<double>();
  EXPECT_NEAR(sum, summary["relative_viscosity"]["mean"].get<double>(), 1e-9);

  const ResultsReader results(place / "results/results.h5");
  const std::vector<double> viscosity = results.series("relative_viscosity");
  ASSERT_EQ(viscosity.size(), 21u);
  for (std::size_t row = 0; row < viscosity.size(); ++row) {
    double parts = 1;
    for (const Column& column : results.columns())
      if (column.name.ends_with("_xy")) parts += results.series(column.name)[row];
    EXPECT_NEAR(parts, viscosity[row], 1e-9 * viscosity[row]) << row;
  }
}

TEST(Run, FilesTellTheSame) {
  const Workplace place;
  summary_of(place, "results", {});
  const ResultsReader results(place / "results/results.h5");
  const CsvTable csv = read_csv(place / "results/series.csv");
  ASSERT_EQ(csv.rows(), results.sample_count());
  for (const Column& column : results.columns()) EXPECT_EQ(csv.column(column.name), results.series(column.name));

  ASSERT_EQ(results.snapshot_count(), 5u);
  const Snapshot last = results.snapshot(4);
  const XyzFrame frame = read_last_xyz_frame(place / "results/particles.xyz");
  EXPECT_EQ(frame.position, last.position);
  EXPECT_EQ(frame.radius, last.radius);
  EXPECT_NEAR(last.strain, 0.02, 1e-12);
  EXPECT_THAT(results.resolved_input(), HasSubstr("seed = 3"));
  EXPECT_THAT(results.provenance().command_line, HasSubstr("--output"));
}

TEST(Run, FilesBesideTheResultsCanBeLeftOut) {
  const Workplace place;
  summary_of(place, "results", {"output.csv=false", "output.xyz=false", "output.paraview=false"});
  for (const char* file : {"series.csv", "particles.xyz", "particles.xdmf"})
    EXPECT_FALSE(std::filesystem::exists(place / "results/" + file)) << file;
  EXPECT_TRUE(std::filesystem::exists(place / "results/results.h5"));
}

TEST(Run, ForceReplacesAllFilesOfTheRunBefore) {
  const Workplace place;
  summary_of(place, "results", {});
  const std::string before = content_of(place / "results/particles.xyz");
  std::vector<std::string> again =
      run_arguments(place / "results.toml", place / "results", {"suspension.seed=4", "output.csv=false"});
  again.push_back("--force");
  EXPECT_EQ(stresslet(again).code, 0);
  EXPECT_NE(content_of(place / "results/particles.xyz"), before);
  EXPECT_FALSE(std::filesystem::exists(place / "results/series.csv")) << "a series of another run must not stay";
}

TEST(Run, SameBitsForAnyNumberOfThreads) {
  const Workplace place;
  Json one = summary_of(place, "one", {"suspension.count=300", "run.strain=0.01"});
  Json three = summary_of(place, "three", {"suspension.count=300", "run.strain=0.01", "run.threads=3"});
  for (const char* cost : {"wall_seconds", "particle_steps_per_second", "seconds_per_unit_strain", "time_share"})
    one.erase(cost), three.erase(cost);
  EXPECT_EQ(one, three);
  EXPECT_EQ(content_of(place / "one/series.csv"), content_of(place / "three/series.csv"));
  EXPECT_EQ(content_of(place / "one/particles.xyz"), content_of(place / "three/particles.xyz"));
}

TEST(Run, StandardOutputHoldsTheResultAndQuietSilencesTheRest) {
  const Workplace place;
  const Outcome outcome = stresslet(run_arguments(place.write("case.toml", small_case()), place / "results"));
  EXPECT_THAT(outcome.out, HasSubstr("relative viscosity"));
  EXPECT_EQ(outcome.err, "");
}

TEST(Run, PlanAndPlainProgressLinesWhenNotATerminal) {
  const Workplace place;
  const Outcome outcome = stresslet({"run", place.write("case.toml", small_case()), "--output", place / "results"});
  EXPECT_THAT(outcome.err, HasSubstr("bound by"));
  EXPECT_EQ(outcome.err.find('\r'), std::string::npos);
  EXPECT_EQ(outcome.err.find('\x1b'), std::string::npos);
}

struct Choice {
  const char* name;
  std::vector<std::string> assignments;
};
std::ostream& operator<<(std::ostream& out, const Choice& choice) { return out << choice.name; }

class EveryChoice : public ::testing::TestWithParam<Choice> {};

TEST_P(EveryChoice, RunsAndGivesFiniteNumbers) {
  const Workplace place;
  const Json summary = summary_of(place, "results", GetParam().assignments);
  expect_finite_numbers(summary);
  expect_finite_series(place / "results");
}

INSTANTIATE_TEST_SUITE_P(
    Run, EveryChoice,
    ::testing::Values(
        Choice{"NLM", {"model.name=NLM"}}, Choice{"CLM", {"model.name=CLM"}}, Choice{"NLM_S", {"model.name=NLM-S"}},
        Choice{"CLM_S", {"model.name=CLM-S"}}, Choice{"CLM_SS", {"model.name=CLM-SS"}},
        Choice{"GRM", {"model.name=GRM"}},
        Choice{"ContactsAlone", {"model.lubrication=none", "model.drag=false", "model.stresslet=false"}},
        Choice{"ContactsAndDrag", {"model.lubrication=none", "model.drag=true", "model.stresslet=true"}},
        Choice{"Hertz", {"contact.normal=hertz"}},
        Choice{"Dashpot", {"contact.restitution=0.5", "contact.coulomb_limit=spring-dashpot"}},
        Choice{"OverlapInPlaceOfStiffness", {"contact.largest_overlap=0.01"}},
        Choice{"Frictionless", {"contact.friction=0"}},
        Choice{"Explicit", {"time.scheme=explicit", "run.strain=0.005", "run.average_from=0.002"}},
        Choice{"Inertialess", {"time.scheme=inertialess"}}, Choice{"Walls", {"flow.boundary=walls"}},
        Choice{"WallsGRM", {"flow.boundary=walls", "model.name=GRM"}},
        Choice{"WallsInertialess", {"flow.boundary=walls", "time.scheme=inertialess"}},
        Choice{"WallsExplicit",
               {"flow.boundary=walls", "time.scheme=explicit", "run.strain=0.005", "run.average_from=0.002"}},
        Choice{"Periodic", {"flow.boundary=periodic"}},
        Choice{"PeriodicInertialess", {"flow.boundary=periodic", "time.scheme=inertialess"}},
        Choice{"Monodisperse",
               {"suspension.sizes.law=monodisperse", "suspension.sizes.diameters=", "suspension.sizes.volume_shares="}},
        Choice{"Lognormal",
               {"suspension.sizes.law=lognormal", "suspension.sizes.median_diameter=1", "suspension.sizes.sigma=0.2",
                "suspension.sizes.smallest=0.7", "suspension.sizes.largest=1.4"}},
        Choice{"SteadyStateDetected", {"run.average_from="}}, Choice{"RelativeError", {"run.relative_error=0.5"}},
        Choice{"SlenderBox", {"suspension.box_aspect=[2, 1, 1]", "suspension.count=150"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Run, GrandResistanceHasAStrainPartAndStaysNearTheCompleteLaw) {
  const Workplace place;
  const Json complete = summary_of(place, "complete", {"model.name=CLM-S"});
  const Json grand = summary_of(place, "grand", {"model.name=GRM"});
  EXPECT_NE(grand["contribution"]["lubrication_strain"]["mean"], 0.0);
  EXPECT_EQ(complete["contribution"]["lubrication_strain"]["mean"], 0.0);
  const double ratio =
      grand["relative_viscosity"]["mean"].get<double>() / complete["relative_viscosity"]["mean"].get<double>();
  EXPECT_GT(ratio, 0.9);
  EXPECT_LT(ratio, 1.1);
}

TEST(Run, WallsShearTheSuspension) {
  const Workplace place;
  const Json summary = summary_of(place, "walls", {"flow.boundary=walls", "run.strain=0.1", "run.average_from=0.05"});
  const double slope = summary["velocity_slope"], viscosity = summary["relative_viscosity"]["mean"];
  EXPECT_GT(slope, 0.7);
  EXPECT_LT(slope, 1.1);
  EXPECT_GT(viscosity, 2.0);
  EXPECT_LT(viscosity, 60.0);
}

TEST(Run, QuiescentSuspensionStaysAtRest) {
  const Workplace place;
  summary_of(place, "rest", {"flow.boundary=periodic", "contact.friction=0"});
  const ResultsReader results(place / "rest/results.h5");
  const Snapshot first = results.snapshot(0), last = results.snapshot(results.snapshot_count() - 1);
  for (std::size_t k = 0; k < first.position.size(); ++k) {
    const double moved = std::abs(last.position[k] - first.position[k]);
    EXPECT_LT(std::min(moved, std::abs(moved - first.box.length[k % 3])), 1e-6);
  }
}

/// A later run from the last snapshot: same particles, same box, offset included.
TEST(Run, StartsFromTheXyzOfAnEarlierRun) {
  const Workplace place;
  summary_of(place, "first", {});
  const std::vector<std::string> from_file{"suspension.solid_fraction=", "suspension.count=", "suspension.seed=",
                                           "suspension.file=" + (place / "first/particles.xyz")};
  summary_of(place, "second", from_file);
  const ResultsReader first(place / "first/results.h5"), second(place / "second/results.h5");
  const Snapshot end = first.snapshot(4), start = second.snapshot(0);
  EXPECT_EQ(start.radius, end.radius);
  EXPECT_NEAR(start.box.offset, end.box.offset, 1e-12);
  EXPECT_GT(end.box.offset, 0.05);
  for (std::size_t k = 0; k < end.position.size(); ++k) EXPECT_NEAR(start.position[k], end.position[k], 1e-12);
  EXPECT_NEAR(second.series("relative_viscosity")[0], first.series("relative_viscosity").back(),
              0.15 * first.series("relative_viscosity").back());
}

TEST(Run, StartsFromCsvWithABox) {
  const Workplace place;
  std::string rows = "x,y,z,diameter\n";
  for (int k = 0; k < 27; ++k) {
    const auto coordinate = [](int cell) { return std::to_string(0.7 + 1.3 * cell); };
    rows += coordinate(k % 3) + "," + coordinate(k / 3 % 3) + "," + coordinate(k / 9) + ",1\n";
  }
  const std::string csv = place.write("start.csv", rows);
  const Json summary =
      summary_of(place, "results",
                 {"suspension.solid_fraction=", "suspension.count=", "suspension.seed=", "suspension.file=" + csv,
                  "suspension.box=[4, 4, 4]"});
  EXPECT_EQ(summary["particles"], 27);
  EXPECT_NEAR(summary["solid_fraction"].get<double>(), 27 * M_PI / 6 / 64, 1e-12);
}

}  // namespace
}  // namespace stresslet
