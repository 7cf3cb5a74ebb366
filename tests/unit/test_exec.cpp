#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/chunk_sum.hpp"
#include "stresslet/exec/simd.hpp"
#include "stresslet/exec/thread_team.hpp"

namespace stresslet {
namespace {

TEST(Simd, LogarithmAgreesWithTheLibrary) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> exponent(-300, 300);
  for (int trial = 0; trial < 100000; ++trial) {
    const Pack x([&](auto) { return trial % 2 ? std::exp2(exponent(random)) : 1 + exponent(random) / 1000; });
    const Pack y = natural_log(x);
    for (std::size_t k = 0; k < pack_width; ++k)
      ASSERT_NEAR(y[k], std::log(x[k]), 4e-16 * std::max(1.0, std::abs(std::log(x[k])))) << x[k];
  }
}

TEST(ThreadTeam, SharesCoverEveryItemOnceAndRespectTheGrain) {
  for (int size : {1, 2, 3, 5}) {
    ThreadTeam team(size);
    for (std::size_t count : {0u, 1u, 7u, 64u, 1001u}) {
      std::vector<int> touched(count, 0);
      team.run([&](Member& member) {
        const Range range = member.share(count, 8);
        EXPECT_TRUE(range.begin % 8 == 0 || range.begin == count);
        for (std::size_t i = range.begin; i < range.end; ++i) ++touched[i];
      });
      EXPECT_EQ(std::accumulate(touched.begin(), touched.end(), std::size_t(0)), count);
    }
  }
}

TEST(ThreadTeam, BarrierOrdersWritesOfAllMembers) {
  ThreadTeam team(3);
  std::vector<int> slot(3, 0);
  team.run([&](Member& member) {
    for (int round = 1; round <= 2000; ++round) {
      slot[std::size_t(member.rank())] = round;
      member.barrier();
      for (int other : slot) ASSERT_EQ(other, round);
      member.barrier();
    }
  });
}

TEST(ThreadTeam, AnExceptionOfAllReachesTheCaller) {
  ThreadTeam team(2);
  EXPECT_THROW(team.run([](Member&) { throw std::runtime_error("together"); }), std::runtime_error);
  int calls = 0;
  team.run([&](Member& member) { calls += member.rank() == 0; });
  EXPECT_EQ(calls, 1);
}

TEST(ChunkSum, SameBitsForAnyNumberOfThreads) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  std::vector<double> values(5000);
  for (double& v : values) v = normal(random);
  std::vector<double> results;
  for (int size : {1, 2, 3, 4}) {
    ThreadTeam team(size);
    ChunkSum<double> sum;
    sum.resize(values.size());
    team.run([&](Member& member) {
      const double total = sum(member, values.size(), [&](std::size_t begin, std::size_t end) {
        return std::accumulate(values.begin() + long(begin), values.begin() + long(end), 0.0);
      });
      if (member.rank() == 0) results.push_back(total);
    });
  }
  for (double r : results) EXPECT_EQ(r, results[0]);
}

}  // namespace
}  // namespace stresslet
