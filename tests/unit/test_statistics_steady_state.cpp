#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "stresslet/rheology/statistics.hpp"
#include "stresslet/rheology/steady_state.hpp"

namespace stresslet {
namespace {

/// Gaussian noise with correlation exp(-k / 10), mean 5, plus a transient height exp(-k / decay).
std::vector<double> series_with_transient(std::size_t n, double height, double decay, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double a = std::exp(-0.1);
  double y = normal(random);
  std::vector<double> x(n);
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = 5 + y + height * std::exp(-double(k) / decay);
    y = a * y + std::sqrt(1 - a * a) * normal(random);
  }
  return x;
}

TEST(SteadyState, DropsTheTransientAndLittleMore) {
  // 30 exp(-k / 100) has sunk to the noise at k = 340 and to a tenth of it at 570.
  double squares = 0, dropped = 0, bias = 0;
  const int realisations = 200;
  for (int r = 0; r < realisations; ++r) {
    const std::vector<double> x = series_with_transient(5000, 30, 100, std::uint64_t(r));
    const SteadyState steady = find_steady_state(x);
    EXPECT_TRUE(steady.reached);
    EXPECT_GE(steady.begin, 150u);
    EXPECT_LE(steady.begin, 2500u);
    dropped += double(steady.begin) / realisations;
    const Estimate e = estimate_mean(std::span(x).subspan(steady.begin));
    squares += std::pow((e.mean - 5) / e.error, 2) / realisations;
    bias += (e.mean - 5) / realisations;
  }
  EXPECT_GT(dropped, 340);
  EXPECT_LT(dropped, 1000);
  EXPECT_LT(std::sqrt(squares), 1.4);
  EXPECT_NEAR(bias, 0, 0.03);
}

TEST(SteadyState, KeepsAStationarySeries) {
  double dropped = 0;
  for (int r = 0; r < 200; ++r)
    dropped += double(find_steady_state(series_with_transient(5000, 0, 1, std::uint64_t(r))).begin) / 200;
  EXPECT_LT(dropped, 500);
}

TEST(SteadyState, SeriesThatStillDriftsHasNotReachedIt) {
  const SteadyState steady = find_steady_state(series_with_transient(5000, 100, 3000, 1));
  EXPECT_FALSE(steady.reached);
  EXPECT_LE(steady.begin, 2500u);
  EXPECT_GE(steady.begin, 2490u);
}

TEST(SteadyState, StepIsFoundToTheBatch) {
  std::vector<double> x(200, 1.0);
  for (std::size_t k = 0; k < 40; ++k) x[k] = 9;
  const SteadyState steady = find_steady_state(x);
  EXPECT_EQ(steady.begin, 40u);
  EXPECT_TRUE(steady.reached);
}

TEST(SteadyState, ConstantAndShortSeriesAreKeptWhole) {
  const SteadyState constant = find_steady_state(std::vector<double>(100, 0.1));
  EXPECT_EQ(constant.begin, 0u);
  EXPECT_TRUE(constant.reached);
  const SteadyState few = find_steady_state(std::vector<double>{9, 1, 1, 1, 1, 1, 1});
  EXPECT_EQ(few.begin, 0u);
  EXPECT_FALSE(few.reached);
  EXPECT_FALSE(find_steady_state({}).reached);
}

}  // namespace
}  // namespace stresslet
