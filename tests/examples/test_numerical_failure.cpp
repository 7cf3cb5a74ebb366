/// Exit code 3: the quantity is named, the results so far stay readable, and the run can be continued from them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../program.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/results_file.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;

/// No run balances its energy to 1e-9: stress and dissipation are sampled at intervals.
TEST(NumericalFailure, StopsWithAMessageAndKeepsTheLastGoodState) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case()), results = place / "results";
  const Outcome failed = stresslet(run_arguments(input, results, {"run.strain=0.5", "run.monitor_tolerance=1e-9"}));
  EXPECT_EQ(failed.code, 3);
  EXPECT_THAT(failed.err, HasSubstr("stress power and dissipation part"));
  for (const char* part : {"\n  why: ", "\n  fix: ", "\n  kept: "}) EXPECT_THAT(failed.err, HasSubstr(part));
  EXPECT_THAT(failed.err, HasSubstr("stresslet restart " + results));
  EXPECT_THAT(failed.err, HasSubstr("start a new run with a smaller time.step"));
  EXPECT_FALSE(std::filesystem::exists(results + "/summary.json"));

  const std::string rest = results + "/uncommitted.csv";
  EXPECT_THAT(failed.err, HasSubstr(rest));
  EXPECT_GT(read_csv(rest).rows(), 10u);

  EXPECT_GE(ResultsReader(results + "/results.h5").sample_count(), 1u);
  const Outcome again = stresslet(restart_arguments(results));
  EXPECT_EQ(again.code, 3);
  const Outcome tolerant = stresslet(restart_arguments(results, {"run.monitor_tolerance=0.2", "run.strain=0.22"}));
  EXPECT_EQ(tolerant.code, 0) << tolerant.err;
  EXPECT_EQ(ResultsReader(results + "/results.h5").sample_count(), 221u);
  EXPECT_FALSE(std::filesystem::exists(rest));
}

/// The failure of a run that was replaced by force leaves no summary of the earlier one.
TEST(NumericalFailure, LeavesNoSummaryOfAnEarlierRun) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case()), results = place / "results";
  ASSERT_EQ(stresslet(run_arguments(input, results)).code, 0);
  std::vector<std::string> again = run_arguments(input, results, {"run.strain=0.5", "run.monitor_tolerance=1e-9"});
  again.push_back("--force");
  EXPECT_EQ(stresslet(again).code, 3);
  EXPECT_FALSE(std::filesystem::exists(results + "/summary.json"));
}

}  // namespace
}  // namespace stresslet
