/// What a run that failed says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../numerical_failure.hpp"
#include "output_samples.hpp"
#include "stresslet/simulation/run_parts.hpp"

namespace stresslet {
namespace {

using namespace output_samples;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// Samples since the last commit that cannot be kept are no other failure.
TEST(FinishOrExplain, NamesTheFailureWhereItsSamplesAreLost) {
  const TemporaryFolder folder;
  ResultsFolder results = ResultsFolder::start(folder.path(), columns(), "a = 1", provenance("run", 1, 1));
  results.commit(checkpoint(0));
  results.add_sample(sample(1));
  std::filesystem::create_directories(folder / uncommitted_csv_name / "in the way");
  const std::string message = testing::failure_of([&] {
    finish_or_explain(
        results, "its last state",
        []() -> ExitCode {
          throw NumericalFailure({"", "the fluid broke", "", ""});
        },
        [] { return std::string("strain 1"); });
  });
  EXPECT_THAT(message, AllOf(HasSubstr("the fluid broke"), HasSubstr("all results up to strain 1"),
                             HasSubstr("uncommitted.csv could not be written")));
}

}  // namespace
}  // namespace stresslet
