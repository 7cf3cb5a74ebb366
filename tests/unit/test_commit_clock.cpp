/// When a commit is due: by the clock, and by what the last one took with everything that it writes.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "stresslet/simulation/run_parts.hpp"

namespace stresslet {
namespace {

TEST(CommitClock, IsDueAfterItsInterval) {
  const CommitClock at_once(0), much_later(1e6);
  EXPECT_TRUE(at_once.due());
  EXPECT_FALSE(much_later.due());
}

TEST(CommitClock, WaitsFiftyTimesWhatTheLastCommitTook) {
  CommitClock clock(0);
  clock.run([] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); });
  EXPECT_GE(clock.cost(), 0.005);
  EXPECT_FALSE(clock.due());
  const Timer timer;
  while (!clock.due()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_GE(timer.seconds(), 0.9 * 50 * clock.cost());
}

}  // namespace
}  // namespace stresslet
