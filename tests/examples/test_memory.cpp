/// The memory that `stresslet check` promises, against what the system counts.
#include <gtest/gtest.h>

#include "../program.hpp"
#include "stresslet/simulation/plan.hpp"

namespace stresslet {
namespace {

using namespace program;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

void expect_estimate_within_a_factor_of_two(int count) {
  if (sanitized) GTEST_SKIP() << "sanitizers keep memory of their own";
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  const std::vector<std::string> keys{"suspension.count=" + std::to_string(count), "run.strain=0.002",
                                      "run.average_from=0"};
  const Outcome outcome = stresslet(run_arguments(input, place / "results", keys));
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const double estimate = make_plan(read_case(input, keys)).memory_bytes();
  EXPECT_GT(estimate, 0.5 * outcome.peak_bytes);
  EXPECT_LT(estimate, 2.0 * outcome.peak_bytes);
}

TEST(Memory, OfASmallSuspension) { expect_estimate_within_a_factor_of_two(2000); }

TEST(LongMemory, OfALargeSuspension) { expect_estimate_within_a_factor_of_two(20000); }

}  // namespace
}  // namespace stresslet
