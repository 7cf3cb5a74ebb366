#include "stresslet/rheology/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stresslet {

namespace {

constexpr double window_times = 5;
constexpr std::size_t fewest_blocks = 4;
constexpr std::size_t fewest_samples = 8;
constexpr double fewest_independent_samples = 10;
/// Longer series are averaged in pairs first: the sum over lags is quadratic, and its result does not change.
constexpr std::size_t longest_series = 4096;

struct Moments {
  double mean, variance;
};

/// Mean and population variance; the first sample as origin makes both exact for a constant series.
Moments moments(std::span<const double> series) {
  const double origin = series[0];
  double sum = 0;
  for (double v : series) sum += v - origin;
  const double shift = sum / double(series.size());
  double squares = 0;
  for (double v : series) squares += (v - origin - shift) * (v - origin - shift);
  return {origin + shift, squares / double(series.size())};
}

/// Means of neighbouring pairs; an odd last sample is left out.
std::vector<double> pair_means(std::span<const double> series) {
  std::vector<double> means(series.size() / 2);
  for (std::size_t i = 0; i < means.size(); ++i) means[i] = 0.5 * (series[2 * i] + series[2 * i + 1]);
  return means;
}

double covariance(const std::vector<double>& deviation, std::size_t lag) {
  double sum = 0;
  for (std::size_t i = lag; i < deviation.size(); ++i) sum += deviation[i] * deviation[i - lag];
  return sum;
}

}  // namespace

double student_factor(double degrees_of_freedom) {
  const double u = 1 / std::max(1.0, degrees_of_freedom);
  return 1 + u * (0.5 + u * (0.25 + u * 0.0625));
}

double MeanError::error() const { return raw * student_factor(degrees_of_freedom); }

MeanError autocorrelation_error(std::span<const double> series) {
  std::vector<double> x(series.begin(), series.end());
  while (x.size() > longest_series) x = pair_means(x);
  const Moments m = moments(x);
  const double n = double(x.size());
  if (m.variance == 0) return {0, n - 1};
  for (double& v : x) v -= m.mean;

  double time = 0.5;                    // Sokal's integrated correlation time, in samples
  double covariances = n * m.variance;  // sum over pairs of samples within the window, about the mean
  double pairs = n;                     // their number
  std::size_t window = 0;
  while (window + 1 < x.size() / 2 && double(window) < window_times * time) {
    ++window;
    const double c = covariance(x, window);
    const double count = n - double(window);
    time += c / (count * m.variance);
    covariances += 2 * c;
    pairs += 2 * count;
  }
  // var(mean) = (covariances + pairs var(mean)) / n^2; the window is below n/2, so that pairs < n^2.
  const double variance_of_mean = std::max(0.0, covariances) / (n * n - pairs);
  return {std::sqrt(variance_of_mean), n / (2.0 * double(window) + 1)};
}

MeanError blocking_error(std::span<const double> series) {
  std::vector<double> blocks(series.begin(), series.end());
  const double n = double(series.size());
  const double independent = moments(series).variance / n;
  for (double length = 1;; length *= 2) {
    const double freedom = double(blocks.size()) - 1;
    const double variance_of_mean = moments(blocks).variance / freedom;
    const double growth = independent > 0 ? variance_of_mean / independent : 1;
    const bool long_enough = length * length * length > 2 * n * growth * growth;
    if (long_enough || blocks.size() / 2 < fewest_blocks) return {std::sqrt(variance_of_mean), freedom};
    blocks = pair_means(blocks);
  }
}

Estimate estimate_mean(std::span<const double> series) {
  Estimate estimate;
  estimate.samples = series.size();
  if (series.empty()) return estimate;
  const double n = double(series.size());
  const auto [mean, variance] = moments(series);
  estimate.mean = mean;
  if (series.size() < fewest_samples) {
    estimate.correlation_samples = n;
    estimate.error = series.size() == 1 ? std::abs(mean) : std::sqrt(variance * n / (n - 1)) * student_factor(n - 1);
    return estimate;
  }
  const MeanError a = autocorrelation_error(series), b = blocking_error(series);
  estimate.error = std::max(a.error(), b.error());
  if (variance > 0) estimate.correlation_samples = n * std::pow(std::max(a.raw, b.raw), 2) / variance;
  estimate.reliable = n >= fewest_independent_samples * estimate.correlation_samples;
  return estimate;
}

}  // namespace stresslet
