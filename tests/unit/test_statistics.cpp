#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "stresslet/rheology/statistics.hpp"

namespace stresslet {
namespace {

/// Gaussian process x_{k+1} = a x_k + sqrt(1 - a^2) noise of mean `truth` and variance 1.
class AutoregressiveProcess {
 public:
  /// `time`: Sokal's integrated correlation time 1/2 + sum rho in samples, so that a = (2 time - 1) / (2 time + 1).
  AutoregressiveProcess(double time, double truth, std::uint64_t seed)
      : a_((2 * time - 1) / (2 * time + 1)), truth_(truth), random_(seed) {}

  std::vector<double> series(std::size_t n) {
    std::vector<double> x(n);
    double y = normal_(random_);
    for (double& v : x) v = truth_ + y, y = a_ * y + std::sqrt(1 - a_ * a_) * normal_(random_);
    return x;
  }

  /// Exact standard deviation of the mean of n samples: n^-2 sum_ij a^|i-j|.
  double exact_error(std::size_t n) const {
    double sum = 1;
    for (std::size_t t = 1; t < n; ++t) sum += 2 * (1 - double(t) / double(n)) * std::pow(a_, double(t));
    return std::sqrt(sum / double(n));
  }

 private:
  double a_, truth_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

class MeanOfCorrelatedSeries : public testing::TestWithParam<std::tuple<double, double>> {};

TEST_P(MeanOfCorrelatedSeries, ErrorIsHonest) {
  const auto [time, times] = GetParam();
  const std::size_t n = std::size_t(time * times);
  const double truth = 13.6;
  const int realisations = 400;
  AutoregressiveProcess process(time, truth, 7);
  const double exact = process.exact_error(n);
  double squares = 0, relative_error = 0, correlation = 0;
  int beyond_three = 0, reliable = 0;
  for (int r = 0; r < realisations; ++r) {
    const Estimate e = estimate_mean(process.series(n));
    const double z = (e.mean - truth) / e.error;
    squares += z * z / realisations;
    relative_error += e.error / exact / realisations;
    correlation += e.correlation_samples / realisations;
    beyond_three += std::abs(z) > 3;
    reliable += e.reliable;
    EXPECT_EQ(e.samples, n);
  }
  EXPECT_GT(std::sqrt(squares), 0.85);
  EXPECT_LT(std::sqrt(squares), 1.25);
  EXPECT_GT(relative_error, 0.95);
  EXPECT_LT(relative_error, 1.4);
  EXPECT_LE(beyond_three, realisations * 25 / 1000);
  EXPECT_GT(correlation, 0.85 * 2 * time);
  EXPECT_LT(correlation, 1.5 * 2 * time);  // the larger of two estimates leans upwards
  if (times >= 100) {
    EXPECT_EQ(reliable, realisations);
  }
}

// White noise has time 0.5.
INSTANTIATE_TEST_SUITE_P(TimesAndLengths, MeanOfCorrelatedSeries,
                         testing::Values(std::tuple(0.5, 40.0), std::tuple(0.5, 100.0), std::tuple(0.5, 1000.0),
                                         std::tuple(2.0, 20.0), std::tuple(2.0, 100.0), std::tuple(2.0, 1000.0),
                                         std::tuple(20.0, 20.0), std::tuple(20.0, 100.0), std::tuple(20.0, 1000.0),
                                         std::tuple(200.0, 20.0), std::tuple(200.0, 100.0)));

TEST(MeanOfCorrelatedSeries, TwoTimeScalesAreSeen) {
  // Half the variance white, half with correlation time 40: the fast part hides the slow one from a short window.
  const int realisations = 400;
  const std::size_t n = 8000;
  AutoregressiveProcess slow(40, 0, 1), fast(0.5, 0, 2);
  const double exact = std::hypot(slow.exact_error(n), fast.exact_error(n));
  double squares = 0, relative_error = 0;
  for (int r = 0; r < realisations; ++r) {
    std::vector<double> x = slow.series(n);
    const std::vector<double> noise = fast.series(n);
    for (std::size_t i = 0; i < n; ++i) x[i] += noise[i];
    const Estimate e = estimate_mean(x);
    squares += std::pow(e.mean / e.error, 2) / realisations;
    relative_error += e.error / exact / realisations;
  }
  EXPECT_GT(std::sqrt(squares), 0.85);
  EXPECT_LT(std::sqrt(squares), 1.25);
  EXPECT_GT(relative_error, 0.9);
  EXPECT_LT(relative_error, 1.25);
}

TEST(MeanOfCorrelatedSeries, EachEstimateAgreesWithTheExactErrorInALongSeries) {
  AutoregressiveProcess process(10, 0, 3);
  const std::size_t n = 200000;
  const std::vector<double> x = process.series(n);
  EXPECT_NEAR(autocorrelation_error(x).raw / process.exact_error(n), 1, 0.05);
  EXPECT_NEAR(blocking_error(x).raw / process.exact_error(n), 1, 0.1);
}

TEST(MeanOfCorrelatedSeries, TooShortForItsCorrelationIsMostlySaid) {
  AutoregressiveProcess process(100, 0, 4);
  int reliable = 0;
  for (int r = 0; r < 200; ++r) reliable += estimate_mean(process.series(400)).reliable;
  EXPECT_LE(reliable, 40);
}

TEST(MeanOfCorrelatedSeries, ScalesAndShiftsWithTheSeries) {
  AutoregressiveProcess process(5, 0, 5);
  std::vector<double> x = process.series(1000);
  const Estimate before = estimate_mean(x);
  for (double& v : x) v = 3 - 8 * v;
  const Estimate after = estimate_mean(x);
  EXPECT_NEAR(after.mean, 3 - 8 * before.mean, 1e-12);
  EXPECT_NEAR(after.error, 8 * before.error, 1e-12);
  EXPECT_NEAR(after.correlation_samples, before.correlation_samples, 1e-9);
}

TEST(MeanOfCorrelatedSeries, ConstantHasNoError) {
  const Estimate e = estimate_mean(std::vector<double>(1000, 0.1));
  EXPECT_EQ(e.mean, 0.1);
  EXPECT_EQ(e.error, 0);
  EXPECT_EQ(e.correlation_samples, 1);
  EXPECT_TRUE(e.reliable);
}

TEST(MeanOfCorrelatedSeries, DriftIsUnreliable) {
  std::vector<double> x(1000);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = double(i);
  const Estimate e = estimate_mean(x);
  EXPECT_FALSE(e.reliable);
  EXPECT_GT(e.error, 100);  // the halves differ by 500
  EXPECT_LT(e.error, 1000);
}

TEST(MeanOfCorrelatedSeries, FewSamplesHaveAFiniteUpperBound) {
  const Estimate none = estimate_mean({});
  EXPECT_EQ(none.mean, 0);
  EXPECT_EQ(none.error, 0);
  EXPECT_FALSE(none.reliable);
  const Estimate one = estimate_mean(std::vector<double>{-4});
  EXPECT_EQ(one.mean, -4);
  EXPECT_EQ(one.error, 4);
  EXPECT_FALSE(one.reliable);
  const Estimate three = estimate_mean(std::vector<double>{1, 2, 6});
  EXPECT_EQ(three.mean, 3);
  EXPECT_NEAR(three.error, std::sqrt(7.0) * 1.321, 0.01);  // standard deviation, Student's t at 68.27 %
  EXPECT_FALSE(three.reliable);
  for (std::size_t n = 4; n < 30; ++n) {
    std::vector<double> alternating(n);
    for (std::size_t i = 0; i < n; ++i) alternating[i] = i % 2 ? 1 : -1;
    const Estimate e = estimate_mean(alternating);
    EXPECT_TRUE(std::isfinite(e.error) && std::isfinite(e.mean) && std::isfinite(e.correlation_samples)) << n;
  }
}

TEST(StudentFactor, AgreesWithTables) {
  // Quantiles of Student's t at probability 0.841345.
  EXPECT_NEAR(student_factor(1), 1.8373, 0.03);
  EXPECT_NEAR(student_factor(2), 1.3213, 0.0015);
  EXPECT_NEAR(student_factor(5), 1.1105, 1e-3);
  EXPECT_NEAR(student_factor(10), 1.0526, 1e-3);
  EXPECT_NEAR(student_factor(1e9), 1, 1e-8);
}

}  // namespace
}  // namespace stresslet
