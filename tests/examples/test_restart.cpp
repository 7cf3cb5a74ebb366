/// A run that is stopped, killed or prolonged, and then restarted, equals the unbroken run bit for bit.
///
/// A long run is stopped at a moment nobody chose. Where it stood is read from its checkpoint; the restart goes on for
/// a little strain from there, and an unbroken run to the same strain must have left the same files.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <random>

#include "../program.hpp"
#include "same_results.hpp"
#include "stresslet/io/results_file.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;
using Assignments = std::vector<std::string>;

Checkpoint checkpoint_in(const std::string& folder) { return ResultsReader(folder + "/results.h5").checkpoint(); }

/// Dense enough for contacts from the first strain on, so that friction has a history to keep.
std::string dense_case() {
  std::string text = small_case();
  return text.replace(text.find("0.45"), 4, "0.60");
}

double strain_of(const Checkpoint& checkpoint) { return std::get<double>(checkpoint.scalars.at("strain")); }

Assignments joined(Assignments first, const Assignments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

struct Model {
  const char* name;
  Assignments assignments;
  double further = 0.012;  ///< strain after a stop
};
std::ostream& operator<<(std::ostream& out, const Model& model) { return out << model.name; }

class Restart : public ::testing::TestWithParam<Model> {
 protected:
  /// Starts or restarts a run that would go on for long, and stops it `milliseconds` after its first commit.
  Outcome stopped(const std::vector<std::string>& command, int signal, int milliseconds) {
    const std::string file = results_ + "/results.h5", before = file_identity(file);
    Process process(stresslet_command(command));
    EXPECT_TRUE(process.run_until([&] { return file_identity(file) != before; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    process.send(signal);
    return process.wait();
  }

  std::vector<std::string> long_run() {
    return run_arguments(input_, results_, joined(GetParam().assignments, {"run.strain=1000"}));
  }

  /// Goes on from the checkpoint for a little strain and compares with the run that was never stopped.
  void finish_and_compare(const Assignments& also = {}) {
    const double end = std::ceil(1000 * (strain_of(checkpoint_in(results_)) + GetParam().further)) / 1000;
    const std::string strain = fmt::format("run.strain={:.3f}", end);
    const Outcome restarted = stresslet(restart_arguments(results_, joined({strain}, also)));
    ASSERT_EQ(restarted.code, 0) << restarted.err;
    const Outcome unbroken = stresslet(run_arguments(input_, reference_, joined(GetParam().assignments, {strain})));
    ASSERT_EQ(unbroken.code, 0) << unbroken.err;
    expect_same_results(results_, reference_);
  }

  Workplace place_;
  std::string input_ = place_.write("case.toml", dense_case());
  std::string results_ = place_ / "results", reference_ = place_ / "reference";
};

TEST_P(Restart, AfterATermSignal) {
  const Outcome outcome = stopped(long_run(), SIGTERM, 25);
  ASSERT_EQ(outcome.code, 4) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("stresslet restart " + results_));
  finish_and_compare();
}

TEST_P(Restart, TwiceAndWithOtherThreads) {
  ASSERT_EQ(stopped(long_run(), SIGINT, 5).code, 4);
  ASSERT_EQ(stopped(restart_arguments(results_, {"run.threads=2"}), SIGTERM, 40).code, 4);
  finish_and_compare({"run.threads=3"});
}

TEST_P(Restart, ThreadsChangedOnTheWayDoNotChangeASingleBit) {
  ASSERT_EQ(stopped(long_run(), SIGTERM, 15).code, 4);
  finish_and_compare({"run.threads=2"});
}

TEST_P(Restart, AfterAKillDuringACommit) {
  Process process(stresslet_command(joined(long_run(), settings({"output.commit_every=0"}))));
  ASSERT_TRUE(process.run_until([&] { return std::filesystem::exists(results_ + "/results.h5"); }));
  ASSERT_TRUE(process.run_until([&] { return std::filesystem::exists(results_ + "/results.h5.part"); }));
  process.send(SIGKILL);
  EXPECT_EQ(process.wait().code, 128 + SIGKILL);
  finish_and_compare();
}

INSTANTIATE_TEST_SUITE_P(Run, Restart,
                         ::testing::Values(Model{"SemiImplicit", {"time.scheme=semi-implicit"}},
                                           Model{"Explicit", {"time.scheme=explicit", "run.average_from=0.001"}, 0.004},
                                           Model{"Inertialess", {"time.scheme=inertialess"}},
                                           Model{"Walls", {"flow.boundary=walls", "suspension.solid_fraction=0.5"}},
                                           Model{"Periodic", {"flow.boundary=periodic"}},
                                           Model{
                                               "GrandResistanceHertzDashpot",
                                               {"model.name=GRM", "contact.normal=hertz", "contact.restitution=0.5"}}),
                         [](const auto& test) { return std::string(test.param.name); });

class LongRestart : public Restart {};

TEST_P(LongRestart, AfterKillsAtRandomMoments) {
  std::mt19937 random(std::random_device{}());
  for (int repetition = 0; repetition < 5; ++repetition) {
    std::filesystem::remove_all(results_), std::filesystem::remove_all(reference_);
    const auto milliseconds = [&] { return int(random() % 600); };
    ASSERT_EQ(stopped(joined(long_run(), settings({"output.commit_every=0"})), SIGKILL, milliseconds()).code,
              128 + SIGKILL);
    for (int restart = 0; restart < 2; ++restart)
      ASSERT_EQ(stopped(restart_arguments(results_, {"output.commit_every=0"}), SIGKILL, milliseconds()).code,
                128 + SIGKILL);
    finish_and_compare();
  }
}

INSTANTIATE_TEST_SUITE_P(Run, LongRestart,
                         ::testing::Values(Model{"SemiImplicit", {}}, Model{"Walls", {"flow.boundary=walls"}},
                                           Model{
                                               "Explicit", {"time.scheme=explicit", "run.average_from=0.001"}, 0.004}),
                         [](const auto& test) { return std::string(test.param.name); });

/// A finished run asked for more: the means then start where run.average_from says, as in one long run.
TEST(RestartOfAFinishedRun, GoesOnAsIfItHadBeenOneRun) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  ASSERT_EQ(stresslet(run_arguments(input, place / "results", {"run.strain=0.01"})).code, 0);
  ASSERT_EQ(stresslet(restart_arguments(place / "results", {"run.strain=0.02"})).code, 0);
  ASSERT_EQ(stresslet(run_arguments(input, place / "reference", {"run.strain=0.02"})).code, 0);
  expect_same_results(place / "results", place / "reference");
}

TEST(RestartOfAFinishedRun, RestoresLostFilesBesideTheResults) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  ASSERT_EQ(stresslet(run_arguments(input, place / "results", {"run.strain=0.01"})).code, 0);
  for (const char* file : {"series.csv", "particles.xyz", "particles.xdmf", "summary.json"})
    std::filesystem::remove(place / "results/" + file);
  ASSERT_EQ(stresslet(restart_arguments(place / "results", {"run.strain=0.02"})).code, 0);
  ASSERT_EQ(stresslet(run_arguments(input, place / "reference", {"run.strain=0.02"})).code, 0);
  expect_same_results(place / "results", place / "reference");
}

}  // namespace
}  // namespace stresslet
