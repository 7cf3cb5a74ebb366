#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/sizes/laws.hpp"

namespace stresslet {
namespace {

double power_sum(const std::vector<SizeClassed>& sizes, double power) {
  double sum = 0;
  for (const auto& s : sizes) sum += std::pow(s.diameter, power);
  return sum;
}

std::size_t count_of(const std::vector<SizeClassed>& sizes, int species) {
  std::size_t n = 0;
  for (const auto& s : sizes) n += s.species == species;
  return n;
}

TEST(Discrete, EqualVolumesOfOneAndOnePointFour) {
  // 2.744 : 1 by number: 1000 * 2.744 / 3.744 = 732.9.
  const auto sizes = Discrete::sizes({{1, 1.4}, {}, {1, 1}}, 1000);
  EXPECT_EQ(count_of(sizes, 0), 733u);
  EXPECT_EQ(count_of(sizes, 1), 267u);
  EXPECT_EQ(sizes.front(), (SizeClassed{1, 0}));
  EXPECT_EQ(sizes.back(), (SizeClassed{1.4, 1}));
}

TEST(Discrete, LargestRemainderGivesTheLeftoversToTheLargestFractions) {
  // Exact counts 4.7, 3.1, 2.2 of 10: floors 4, 3, 2; the one left over goes to the first.
  const auto sizes = Discrete::sizes({{1, 2, 3}, {47, 31, 22}, {}}, 10);
  EXPECT_EQ(count_of(sizes, 0), 5u);
  EXPECT_EQ(count_of(sizes, 1), 3u);
  EXPECT_EQ(count_of(sizes, 2), 2u);
}

TEST(Discrete, RefusesWhatItCannotMeet) {
  using Params = Discrete::Params;
  EXPECT_THROW(Discrete::validate(Params{{}, {}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, 2}, {}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, 2}, {1, 1}, {1, 1}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, 2}, {1}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, -2}, {1, 1}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, 2}, {1, -1}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, 2}, {0, 0}, {}}), InputError);
  EXPECT_THROW(Discrete::validate(Params{{1, std::numeric_limits<double>::quiet_NaN()}, {1, 1}, {}}), InputError);
  try {
    Discrete::sizes(Params{{1, 10}, {}, {1, 1}}, 100);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("no particle of diameter 10"));
  }
}

TEST(Lognormal, MomentsOfTheCutDistribution) {
  const double median = 1.3, s = 0.3, smallest = 0.8, largest = 2.5;
  const auto sizes = Lognormal::sizes({median, s, smallest, largest}, 4000);
  const auto phi = [](double t) { return 0.5 * (1 + std::erf(t / std::sqrt(2.0))); };
  const double low = std::log(smallest / median) / s, high = std::log(largest / median) / s;
  for (double k : {1.0, 2.0, 3.0, 6.0}) {
    // E[d^k] of the cut lognormal: exp(k mu + k^2 s^2 / 2) [Phi(high - k s) - Phi(low - k s)] / [Phi(high) - Phi(low)].
    const double expected = std::exp(k * std::log(median) + 0.5 * k * k * s * s) *
                            (phi(high - k * s) - phi(low - k * s)) / (phi(high) - phi(low));
    EXPECT_NEAR(power_sum(sizes, k) / 4000, expected, 1e-5 * expected) << k;
  }
  EXPECT_GE(sizes.front().diameter, smallest);
  EXPECT_LE(sizes.back().diameter, largest);
}

TEST(Lognormal, MedianOfTheUncutDistribution) {
  const auto sizes = Lognormal::sizes({2, 0.5, 0.001, 1000}, 101);
  EXPECT_NEAR(sizes[50].diameter, 2, 1e-12);
  EXPECT_NEAR(sizes[25].diameter * sizes[75].diameter, 4, 1e-11);
}

TEST(Lognormal, RefusesEmptyCuts) {
  EXPECT_THROW(Lognormal::validate({1, 0.2, 2, 1}), InputError);
  EXPECT_THROW(Lognormal::validate({1, 0, 0.5, 2}), InputError);
  EXPECT_THROW(Lognormal::validate({1, 0.2, 0, 2}), InputError);
  EXPECT_THROW(Lognormal::validate({1, 0.01, 2, 3}), InputError);
  EXPECT_NO_THROW(Lognormal::validate({1, 0.2, 2, 3}));
}

TEST(Table, EvenByNumberIsEvenlySpaced) {
  const auto sizes = Table::sizes({{1, 2}, {0, 1}, Table::Basis::number}, 10);
  for (int i = 0; i < 10; ++i) EXPECT_NEAR(sizes[std::size_t(i)].diameter, 1.05 + 0.1 * i, 1e-14);
}

TEST(Table, VolumeSharesComeBackFromTheSample) {
  const Table::Params table{{0.5, 0.8, 1.0, 1.5, 2.5}, {0, 20, 30, 40, 10}, Table::Basis::volume};
  const auto sizes = Table::sizes(table, 20000);
  const double volume = power_sum(sizes, 3);
  double cumulative = 0;
  for (std::size_t row = 0; row < table.diameters.size(); ++row) {
    cumulative += table.shares[row] / 100;
    double below = 0, below_middle = 0;
    const double middle = row == 0 ? 0 : 0.5 * (table.diameters[row - 1] + table.diameters[row]);
    for (const auto& s : sizes) {
      const double v = s.diameter * s.diameter * s.diameter;
      if (s.diameter <= table.diameters[row]) below += v;
      if (s.diameter <= middle) below_middle += v;
    }
    EXPECT_NEAR(below / volume, cumulative, 2e-3) << row;
    EXPECT_NEAR(below_middle / volume, cumulative - 0.5 * table.shares[row] / 100, 2e-3) << row;
  }
}

TEST(Table, FirstRowIsALumpAndSpeciesIsTheRow) {
  const auto sizes = Table::sizes({{1, 2}, {1, 1}, Table::Basis::number}, 4);
  EXPECT_THAT(sizes,
              testing::ElementsAre(SizeClassed{1, 0}, SizeClassed{1, 0}, SizeClassed{1.25, 1}, SizeClassed{1.75, 1}));
}

TEST(Table, RowsWithoutParticlesAreSkipped) {
  const auto sizes = Table::sizes({{1, 2, 3, 4}, {0, 1, 0, 1}, Table::Basis::number}, 1001);
  for (const auto& s : sizes) EXPECT_TRUE(s.diameter <= 2 || s.diameter >= 3) << s.diameter;
}

TEST(Table, RefusesDisorder) {
  EXPECT_THROW(Table::validate({{}, {}, Table::Basis::number}), InputError);
  EXPECT_THROW(Table::validate({{2, 1}, {1, 1}, Table::Basis::number}), InputError);
  EXPECT_THROW(Table::validate({{1, 1}, {1, 1}, Table::Basis::number}), InputError);
  EXPECT_THROW(Table::validate({{1, 2}, {1}, Table::Basis::number}), InputError);
}

}  // namespace
}  // namespace stresslet
