#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "output_samples.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"
#include "stresslet/io/results_folder.hpp"

namespace stresslet {
namespace {

using namespace output_samples;
using testing::HasSubstr;

void add_interval(ResultsFolder& results, std::size_t k) {
  results.add_sample(sample(2 * k));
  results.add_sample(sample(2 * k + 1));
  results.add_snapshot(snapshot(k));
  results.set_profile({"count", "1", "commits", {1}, {double(k)}});
}

ResultsFolder start(const std::filesystem::path& folder) {
  return ResultsFolder::start(folder, columns(), "a = 1", provenance("run", 1, 1));
}

ResultsFolder resume(const std::filesystem::path& folder) {
  return ResultsFolder::resume(folder, columns(), "", provenance("restart", 1, 1));
}

std::string xyz_up_to(std::size_t snapshots) {
  std::string text;
  for (std::size_t k = 0; k < snapshots; ++k) text += xyz_frame(snapshot(k));
  return text;
}

TEST(ResultsFolder, FilesBesideTheResultsFollowEveryCommit) {
  const TemporaryFolder folder;
  ResultsFolder results = start(folder.path());
  for (std::size_t k = 0; k < 3; ++k) {
    add_interval(results, k);
    results.commit(checkpoint(k));
    EXPECT_EQ(read_whole_file(folder / "particles.xyz"), xyz_up_to(k + 1));
    const CsvTable table = read_csv(folder / "series.csv");
    EXPECT_EQ(table.names, (std::vector<std::string>{"strain", "time", "relative_viscosity"}));
    EXPECT_EQ(table.units[1], "1/shear rate");
    ASSERT_EQ(table.rows(), 2 * (k + 1));
    for (std::size_t row = 0; row < table.rows(); ++row)
      EXPECT_EQ(table.column("relative_viscosity")[row], sample(row)[2]);
  }
}

TEST(ResultsFolder, ARestartRebuildsWhatAKilledRunLeftBehind) {
  const TemporaryFolder folder;
  {
    ResultsFolder results = start(folder.path());
    add_interval(results, 0);
    results.commit(checkpoint(0));
  }
  std::ofstream(folder / "particles.xyz", std::ios::app) << "7\nhalf a frame";
  std::filesystem::remove(folder / "series.csv");
  std::filesystem::remove(folder / "particles.xdmf");
  ResultsFolder results = resume(folder.path());
  EXPECT_EQ(read_whole_file(folder / "particles.xyz"), xyz_up_to(1));
  EXPECT_EQ(read_csv(folder / "series.csv").rows(), 2u);
  EXPECT_TRUE(std::filesystem::exists(folder / "particles.xdmf"));
  add_interval(results, 1);
  results.commit(checkpoint(1));
  EXPECT_EQ(read_whole_file(folder / "particles.xyz"), xyz_up_to(2));
  EXPECT_EQ(read_csv(folder / "series.csv").rows(), 4u);
}

TEST(ResultsFolder, SamplesOfAFailedRunAreKeptApartUntilItGoesOn) {
  const TemporaryFolder folder;
  {
    ResultsFolder results = start(folder.path());
    add_interval(results, 0);
    results.commit(checkpoint(0));
    EXPECT_FALSE(results.keep_uncommitted());
    add_interval(results, 1);
    EXPECT_TRUE(results.keep_uncommitted());
  }
  EXPECT_EQ(read_csv(folder / "series.csv").rows(), 2u);
  const CsvTable rest = read_csv(folder / uncommitted_csv_name);
  EXPECT_EQ(rest.names, (std::vector<std::string>{"strain", "time", "relative_viscosity"}));
  ASSERT_EQ(rest.rows(), 2u);
  for (std::size_t row = 0; row < 2; ++row) EXPECT_EQ(rest.column("relative_viscosity")[row], sample(2 + row)[2]);
  resume(folder.path());
  EXPECT_FALSE(std::filesystem::exists(folder / uncommitted_csv_name));
}

TEST(ResultsFolder, ExistingResultsAreKeptUnlessForced) {
  const TemporaryFolder folder;
  {
    ResultsFolder results = start(folder.path());
    add_interval(results, 0);
    results.commit(checkpoint(0));
  }
  std::ofstream(folder / "summary.json") << "{}";
  try {
    prepare_output_folder(folder.path(), false);
    FAIL() << "existing results accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--force"));
    EXPECT_EQ(int(error.code()), 2);
  }
  prepare_output_folder(folder.path(), true);
  ResultsFolder results = start(folder.path());
  results.add_snapshot(snapshot(5));
  EXPECT_EQ(ResultsReader(folder / "results.h5").sample_count(), 2u) << "old results must stand until the first commit";
  EXPECT_TRUE(std::filesystem::exists(folder / "summary.json"));
  results.commit(checkpoint(0));
  EXPECT_EQ(ResultsReader(folder / "results.h5").sample_count(), 0u);
  EXPECT_EQ(read_whole_file(folder / "particles.xyz"), xyz_frame(snapshot(5)));
  EXPECT_FALSE(std::filesystem::exists(folder / "summary.json"));
}

TEST(ResultsFolder, UnusableFoldersAreRefused) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  EXPECT_THROW(prepare_output_folder(folder / "file", true), InputError);
  EXPECT_THROW(prepare_output_folder(folder / "file/below", true), InputError);
  EXPECT_THROW(prepare_output_folder("/proc/stresslet", true), InputError);
  EXPECT_THROW(prepare_output_folder("/proc", true), InputError);
  EXPECT_NO_THROW(prepare_output_folder(folder / "new/and/deep", false));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "new/and/deep"));
}

TEST(ResultsFolder, OnlyTheChosenFilesAreWritten) {
  const TemporaryFolder folder;
  ResultsFolder results =
      ResultsFolder::start(folder.path(), columns(), "", provenance("", 1, 1), {false, false, false});
  add_interval(results, 0);
  results.commit(checkpoint(0));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) files += entry.is_regular_file();
  EXPECT_EQ(files, 1u);
}

TEST(ResultsFolder, OpensInPythonAndEveryXdmfReferenceHolds) {
  const TemporaryFolder folder;
  ResultsFolder results = start(folder.path());
  for (std::size_t k = 0; k < 3; ++k) add_interval(results, k);
  results.commit(checkpoint(0));
  const std::string command =
      "/usr/bin/python3 " STRESSLET_SOURCE_DIR "/tests/unit/output_opens_elsewhere.py " + folder.path().string();
  const int status = std::system(command.c_str());
  if (WIFEXITED(status) && (WEXITSTATUS(status) == 77 || WEXITSTATUS(status) == 127))
    GTEST_SKIP() << "needs /usr/bin/python3 with python3-h5py";
  EXPECT_EQ(status, 0);
}

/// Commits for ever, and after each commit tells the parent its number.
[[noreturn]] void commit_until_killed(const std::filesystem::path& folder, int tell) {
  const bool fresh = !std::filesystem::exists(folder / results_file_name);
  ResultsFolder results = fresh ? start(folder) : resume(folder);
  for (std::size_t k = results.snapshot_count();; ++k) {
    add_interval(results, k);
    results.commit(checkpoint(k, 50));
    if (::write(tell, &k, sizeof k) != sizeof k) ::_exit(1);
  }
}

TEST(ResultsFolder, KilledAtAnyMomentHoldsAllCommits) {
  const TemporaryFolder folder;
  std::mt19937 random(7);
  std::uniform_int_distribution<int> microseconds(0, 30000);
  std::size_t commits = 0;
  for (int kill_number = 0; kill_number < 30; ++kill_number) {
    int pipe_ends[2];
    ASSERT_EQ(::pipe(pipe_ends), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) commit_until_killed(folder.path(), pipe_ends[1]);
    ::close(pipe_ends[1]);
    std::size_t told = 0;
    if (kill_number % 2 == 0) {  // every other child may die while it reopens the files
      EXPECT_EQ(::read(pipe_ends[0], &told, sizeof told), ssize_t(sizeof told)) << "no commit before the kill";
      commits = told + 1;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds(random)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    while (::read(pipe_ends[0], &told, sizeof told) == sizeof told) commits = told + 1;
    ::close(pipe_ends[0]);

    const ResultsReader reader(folder / results_file_name);
    const std::size_t found = reader.snapshot_count();
    EXPECT_GE(found, commits);
    EXPECT_LE(found, commits + 1) << "only a commit whose message was lost may come on top";
    EXPECT_EQ(reader.checkpoint(), checkpoint(found - 1, 50)) << "results and restart state belong together";
    EXPECT_EQ(reader.profile("count").values, std::vector<double>{double(found - 1)});
    const std::vector<double> strain = reader.series("strain");
    ASSERT_EQ(strain.size(), 2 * found);
    for (std::size_t k = 0; k < strain.size(); ++k) ASSERT_EQ(strain[k], sample(k)[0]);
    const std::string xyz = read_whole_file(folder / "particles.xyz");
    EXPECT_TRUE(xyz == xyz_up_to(found) || xyz == xyz_up_to(found - 1)) << "at most one commit behind";
    commits = found;  // what the next child goes on from
  }
  EXPECT_GE(commits, 15u);
}

}  // namespace
}  // namespace stresslet
