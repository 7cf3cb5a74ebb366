/// Fluid cases in the real program: files, stop and restart to the same bits, kills, and runs that become unstable.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "../program.hpp"
#include "stresslet/io/field_file.hpp"
#include "stresslet/io/results_file.hpp"
#include "stresslet/simulation/fluid/lattice_checkpoint.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;
using Assignments = std::vector<std::string>;

/// A cylinder in a channel with an oscillating force: everything that a restart must restore, in a fraction of a
/// second.
constexpr const char* channel = R"(fidelity = "fluid"
[domain]
size = [2, 1]
resolution = 16
[flow]
reynolds = 20
[force]
density = [0.4, 0, 0]
angular_frequency = 3
[boundaries.y_low]
[boundaries.y_high]
velocity = [0.5, 0, 0]
[solid]
cylinders = [[0.5, 0.45, 0.15]]
[run]
end_time = 0.5
threads = 1
[output]
sample_every = 0.05
fields_every = 0.1
profile_every = 0.1
fields = ["velocity", "pressure", "viscous_stress", "solid"]
probes = [[1.5, 0.5]]
)";

constexpr const char* sheared = R"(fidelity = "fluid"
[domain]
size = [1, 1]
resolution = 24
[flow]
reynolds = 50
[boundaries]
shear_rate = 1
[initial]
state = "shear-wave"
waves = [1, 1, 0]
amplitude = 0.2
[run]
end_time = 0.5
threads = 1
[output]
sample_every = 0.05
fields_every = 0.1
)";

std::int64_t step_in(const std::string& folder) {
  return std::get<std::int64_t>(ResultsReader(folder + "/results.h5").checkpoint().scalars.at("step"));
}

std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

void expect_same_results(const std::string& folder, const std::string& reference) {
  const ResultsReader a(folder + "/results.h5"), b(reference + "/results.h5");
  for (const Column& column : b.columns()) EXPECT_EQ(a.series(column.name), b.series(column.name)) << column.name;
  for (const std::string& name : b.profile_names()) EXPECT_EQ(a.profile(name).values, b.profile(name).values) << name;
  EXPECT_EQ(names_in(folder), names_in(reference));
  for (const std::string& name : names_in(reference + "/fields")) {
    const FieldFile x = read_field_file(folder + "/fields/" + name), y = read_field_file(reference + "/fields/" + name);
    ASSERT_EQ(x.fields.size(), y.fields.size());
    for (std::size_t k = 0; k < x.fields.size(); ++k) EXPECT_EQ(x.fields[k].values, y.fields[k].values) << name;
  }
  for (const char* file : {"series.csv", "fields.xdmf"})
    EXPECT_EQ(content_of(folder + "/" + file), content_of(reference + "/" + file)) << file;
  EXPECT_TRUE(read_populations(folder, step_in(folder)) == read_populations(reference, step_in(reference)));
}

struct Kind {
  const char* name;
  const char* text;
};
std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }

class FluidRestart : public ::testing::TestWithParam<Kind> {
 protected:
  /// Starts or restarts a run that would go on for long, and stops it some time after its first commit and fields.
  Outcome stopped(const std::vector<std::string>& command, int signal, int milliseconds) {
    const std::string file = results_ + "/results.h5", before = file_identity(file);
    Process process(stresslet_command(command));
    EXPECT_TRUE(process.run_until([&] {
      return file_identity(file) != before && std::filesystem::exists(results_ + "/fields.xdmf") &&
             names_in(results_ + "/fields").size() > 2;
    }));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    process.send(signal);
    return process.wait();
  }

  std::vector<std::string> long_run(const Assignments& also = {}) {
    std::vector<std::string> command = run_arguments(input_, results_, also);
    for (const std::string& argument : settings({"run.end_time=1000"})) command.push_back(argument);
    return command;
  }

  /// Goes on to the next tenth after the checkpoint and compares with a run that was never stopped.
  void finish_and_compare(const Assignments& also = {}) {
    const std::string shortest = place_ / "shortest";
    ASSERT_EQ(stresslet(run_arguments(input_, shortest, {"run.end_time=0.1"})).code, 0);
    const FieldFile first = field_headers(shortest, std::int64_t(1) << 40).at(1);
    const double step = first.time / double(first.step);
    const double end = 0.1 * std::ceil(10 * double(step_in(results_)) * step + 1);
    const std::string time = "run.end_time=" + std::to_string(end);
    Assignments restart{time};
    restart.insert(restart.end(), also.begin(), also.end());
    const Outcome restarted = stresslet(restart_arguments(results_, restart));
    ASSERT_EQ(restarted.code, 0) << restarted.err;
    const Outcome unbroken = stresslet(run_arguments(input_, reference_, {time}));
    ASSERT_EQ(unbroken.code, 0) << unbroken.err;
    expect_same_results(results_, reference_);
  }

  Workplace place_;
  std::string input_ = place_.write("case.toml", GetParam().text);
  std::string results_ = place_ / "results", reference_ = place_ / "reference";
};

TEST_P(FluidRestart, AfterATermSignalWithOtherThreads) {
  const Outcome outcome = stopped(long_run(), SIGTERM, 150);
  ASSERT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("stresslet restart " + results_));
  finish_and_compare({"run.threads=2"});
}

TEST_P(FluidRestart, AfterKills) {
  ASSERT_EQ(stopped(long_run({"output.commit_every=0"}), SIGKILL, 200).code, 128 + SIGKILL);
  ASSERT_EQ(stopped(restart_arguments(results_, {"output.commit_every=0"}), SIGKILL, 120).code, 128 + SIGKILL);
  finish_and_compare();
}

TEST_P(FluidRestart, OfAFinishedRun) {
  ASSERT_EQ(stresslet(run_arguments(input_, results_, {"run.end_time=0.2"})).code, 0);
  const Outcome again = stresslet(restart_arguments(results_));
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.err, HasSubstr("nothing left to do"));
  ASSERT_EQ(stresslet(restart_arguments(results_, {"run.end_time=0.5"})).code, 0);
  ASSERT_EQ(stresslet(run_arguments(input_, reference_)).code, 0);
  expect_same_results(results_, reference_);
}

INSTANTIATE_TEST_SUITE_P(Run, FluidRestart, ::testing::Values(Kind{"Channel", channel}, Kind{"Sheared", sheared}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(FluidRun, WritesWhatItSaysAndRefusesToOverwrite) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel), results = place / "results";
  const Outcome run = stresslet(run_arguments(input, results));
  ASSERT_EQ(run.code, 0) << run.err;
  const ResultsReader reader(results + "/results.h5");
  EXPECT_EQ(reader.sample_count(), 11u);
  EXPECT_THAT(reader.resolved_input(), HasSubstr("fidelity = \"fluid\""));
  EXPECT_EQ(reader.series("probe_1_velocity_x").size(), 11u);
  EXPECT_EQ(reader.profile("velocity_x").shape, (std::vector<std::size_t>{6, 16}));
  const auto headers = field_headers(results, 1 << 30);
  ASSERT_EQ(headers.size(), 6u);
  EXPECT_NEAR(headers.back().time, 0.5, 0.01);
  EXPECT_EQ(headers[0].fields.size(), 4u);
  const nlohmann::json summary = nlohmann::json::parse(content_of(results + "/summary.json"));
  EXPECT_EQ(summary["status"], "finished");
  EXPECT_GT(summary["solid_fraction"].get<double>(), 0.03);
  for (const char* word : {"kinetic_energy", "dissipation_from_gradients", "results in "})
    EXPECT_THAT(run.out, HasSubstr(word));
  EXPECT_EQ(stresslet(run_arguments(input, results)).code, 2);
  std::vector<std::string> forced = run_arguments(input, results, {"output.fields_every=0.25"});
  forced.push_back("--force");
  EXPECT_EQ(stresslet(forced).code, 0);
  EXPECT_EQ(field_headers(results, 1 << 30).size(), 3u) << "fields of the earlier run are left";
}

/// A part of the domain, every second cell: values of those cells, and a grid that shows where they lie.
TEST(FluidRun, WritesPartsAndStrides) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel);
  ASSERT_EQ(stresslet(run_arguments(input, place / "all", {"run.end_time=0.1"})).code, 0);
  ASSERT_EQ(stresslet(run_arguments(input, place / "part",
                                    {"run.end_time=0.1", "output.fields_from=[1,0.25]", "output.fields_to=[2,1]",
                                     "output.fields_stride=[2,3,1]", "output.fields=[\"velocity\"]"}))
                .code,
            0);
  const auto file = field_headers(place / "all", 1 << 30).back();
  const FieldFile all = read_field_file(place / "all/fields/" + field_file_name(file.step));
  const FieldFile part = read_field_file(place / "part/fields/" + field_file_name(file.step));
  ASSERT_EQ(part.count, (std::array<std::size_t, 3>{8, 4, 1}));
  EXPECT_DOUBLE_EQ(part.spacing[1], 3.0 / 16);
  // Around the centre of cell (16, 4): 16.5/16 and 4.5/16, less half a spacing.
  EXPECT_DOUBLE_EQ(part.origin[0], 16.5 / 16 - 1.0 / 16);
  EXPECT_DOUBLE_EQ(part.origin[1], 4.5 / 16 - 1.5 / 16);
  const auto& velocity = all.fields.at(2);
  ASSERT_EQ(velocity.name, "velocity") << "fields are sorted by name";
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t x = 0; x < 8; ++x)
      EXPECT_EQ(part.fields[0].values[3 * (x + 8 * y)], velocity.values[3 * (16 + 2 * x + 32 * (4 + 3 * y))]);
}

TEST(FluidRun, ResultsDoNotDependOnThreadsAndBlocks) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel);
  ASSERT_EQ(stresslet(run_arguments(input, place / "a", {"run.end_time=0.2"})).code, 0);
  ASSERT_EQ(
      stresslet(run_arguments(input, place / "b", {"run.end_time=0.2", "run.threads=3", "lattice.blocks=[2,3,1]"}))
          .code,
      0);
  expect_same_results(place / "b", place / "a");
}

/// Too little viscosity for too few cells: it becomes unstable, says where, and keeps the fields and the last commit.
TEST(FluidRun, InstabilityNamesTheCellAndKeepsTheFields) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel), results = place / "results";
  const Outcome failed = stresslet(
      run_arguments(input, results,
                    {"flow.reynolds=1e6", "lattice.relaxation_time=0.500005", "lattice.largest_mach=0.3",
                     "lattice.collision=BGK", "force.density=[40,30,0]", "force.angular_frequency=", "run.end_time=50",
                     "output.fields_every=1000", "output.profile_every="}));
  ASSERT_EQ(failed.code, 3) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("cell ("));
  for (const char* part : {"\n  why: ", "\n  fix: ", "\n  kept: ", "the fields of this moment are in"})
    EXPECT_THAT(failed.err, HasSubstr(part));
  EXPECT_EQ(field_headers(results, std::int64_t(1) << 40).size(), 2u);
  EXPECT_GE(ResultsReader(results + "/results.h5").sample_count(), 1u);
}

}  // namespace
}  // namespace stresslet
