#include "stresslet/coupling/calibration/calibrate.hpp"

#include <cmath>
#include <random>
#include <stdexcept>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/subgrid/subgrid_links.hpp"

namespace stresslet {
namespace {

constexpr unsigned seed = 20180;

/// Least value of `f` on [0, 2]: a coarse scan, then golden sections around its best point.
double least_length(const std::function<double(double)>& f) {
  constexpr double longest = 2, spacing = 0.02, golden = 0.6180339887498949;
  double best = 0;
  for (double l = 0; l <= longest; l += spacing)
    if (f(l) < f(best)) best = l;
  double low = std::max(0.0, best - spacing), high = best + spacing;
  while (high - low > 1e-5) {
    const double a = high - golden * (high - low), b = low + golden * (high - low);
    (f(a) < f(b) ? high : low) = f(a) < f(b) ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

void fit_length(SubgridLengths& lengths, double SubgridLengths::*length,
                const std::function<void(const SubgridLengths&, const ErrorVisitor&)>& visit_errors) {
  lengths.*length = least_length([&](double value) {
    SubgridLengths trial = lengths;
    trial.*length = value;
    double sum = 0;
    visit_errors(trial, [&](double error) { sum += std::pow(error, 4); });
    return sum;
  });
}

std::vector<CalibrationPoint> calibration_points(const CalibrationPlan& plan) {
  struct Direction {
    const char* name;
    Vec3<double> direction, across, offset;
  };
  const Direction fixed[] = {{"aligned, on a cell", {1, 0, 0}, {0, 1, 0}, {}},
                             {"aligned, between cells", {1, 0, 0}, {0, 1, 0}, {0.5, 0.5, 0.5}},
                             {"face diagonal", {1, 1, 0}, {-1, 1, 0}, {0.25, 0.1, 0.3}},
                             {"space diagonal", {1, 1, 1}, {1, -1, 0}, {0.2, 0.3, 0.4}}};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> within(-0.5, 0.5);
  std::vector<CalibrationPoint> points;
  PairPlacement p;
  p.radius1 = 0.5 * plan.cells_across;
  p.radius2 = plan.radius_ratio * p.radius1;
  p.edge = plan.edge;
  for (const double gap : plan.gaps) {
    p.gap = gap;
    for (const Direction& d : fixed) {
      p.direction = d.direction;
      p.across = d.across;
      p.offset = d.offset;
      points.push_back({d.name, p});
    }
    for (int k = 0; k < plan.random_directions; ++k) {
      std::array<double, 9> draws{};
      for (std::size_t i = 0; i < 6; ++i) draws[i] = normal(random);
      for (std::size_t i = 6; i < 9; ++i) draws[i] = within(random);
      p.direction = {draws[0], draws[1], draws[2]};
      p.across = {draws[3], draws[4], draws[5]};
      p.offset = {draws[6], draws[7], draws[8]};
      points.push_back({"random", p});
    }
  }
  return points;
}

Eigen::Matrix4d corrected_resistance(const PairMeasurement& m, const std::string& law, const SubgridLengths& lengths,
                                     const SubgridRange& range) {
  const PairPlacement& p = m.placement;
  const double distance = p.radius1 + p.radius2 + p.gap;
  PairResistance<double> k;
  if (!SubgridLaws::dispatch(law, [&](auto l) {
        k = subgrid_resistance<typename decltype(l)::type>(p.radius1, p.radius2, p.gap, lengths, range);
      }))
    throw std::invalid_argument("unknown sub-grid law " + law);
  const Matrix12 film = m.viscosity * pair_resistance_matrix(k, p.direction / norm(p.direction), distance);
  return m.measured + m.motion.transpose() * film * m.motion;
}

std::array<double, 4> corrected_errors(const PairMeasurement& m, const std::string& law, const SubgridLengths& lengths,
                                       const SubgridRange& range) {
  const Eigen::Matrix4d corrected = corrected_resistance(m, law, lengths, range);
  std::array<double, 4> errors{};
  for (Eigen::Index i = 0; i < 4; ++i)
    if (m.exact(i, i) != 0) errors[std::size_t(i)] = corrected(i, i) / m.exact(i, i) - 1;
  return errors;
}

SubgridLengths fit_lengths(const std::vector<PairMeasurement>& measurements, const std::string& law,
                           const SubgridRange& range) {
  SubgridLengths best;
  const auto fit = [&](double SubgridLengths::*length, std::initializer_list<std::size_t> modes) {
    fit_length(best, length, [&](const SubgridLengths& trial, const ErrorVisitor& visit) {
      for (const PairMeasurement& m : measurements) {
        const auto errors = corrected_errors(m, law, trial, range);
        for (const std::size_t mode : modes) visit(errors[mode]);
      }
    });
  };
  fit(&SubgridLengths::normal, {0});
  fit(&SubgridLengths::sliding, {1, 2});
  fit(&SubgridLengths::spin, {3});
  return best;
}

}  // namespace stresslet
