#include "stresslet/coupling/solid_fraction/exact_overlap.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "stresslet/base/constants.hpp"

namespace stresslet {

namespace {

constexpr int points = 16;
constexpr double tolerance = 1e-14;
constexpr int most_halvings = 12;

struct GaussLegendre {
  std::array<double, points> node, weight;

  /// Roots of the Legendre polynomial on [-1, 1] by Newton's method.
  GaussLegendre() {
    for (int k = 0; k < points; ++k) {
      double x = std::cos(pi * (k + 0.75) / (points + 0.5)), slope = 1;
      for (int iteration = 0; iteration < 10; ++iteration) {
        double before = 1, value = x;
        for (int n = 2; n <= points; ++n) {
          const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
          before = value, value = next;
        }
        slope = points * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      node[k] = x;
      weight[k] = 2 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Integral of min(b, sqrt(rho^2 - x^2)) from 0 to x: odd in x, constant beyond rho.
double capped_quarter_disc(double x, double b, double squared_rho) {
  const double rho = std::sqrt(squared_rho), reach = std::min(std::abs(x), rho);
  const double height = std::min(b, rho), flat = std::sqrt(std::max(squared_rho - height * height, 0.0));
  double area = height * std::min(reach, flat);
  if (reach > flat) {
    const double end = std::sqrt(std::max(squared_rho - reach * reach, 0.0));
    const double angle = std::atan2(reach * height - flat * end, height * end + flat * reach);
    area += 0.5 * (reach * end - flat * height + squared_rho * angle);
  }
  return std::copysign(area, x);
}

/// A square [x0, x1] x [y0, y1] with |x0| <= x1, |y0| <= y1.
struct Square {
  double x0, x1, y0, y1;

  /// Area shared with the disc of squared radius `squared_rho` about the origin.
  double shared_with_disc(double squared_rho) const {
    if (squared_rho <= 0) return 0;
    const auto below = [&](double b) {
      return capped_quarter_disc(x1, b, squared_rho) - capped_quarter_disc(x0, b, squared_rho);
    };
    return below(y1) - std::copysign(below(std::abs(y0)), y0);
  }
};

template <class Function>
double integral(const Function& f, double low, double high) {
  static const GaussLegendre rule;
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const double theta = 0.5 * pi * (1 + rule.node[k]);
    sum += rule.weight[k] * std::sin(theta) * f(middle - half * std::cos(theta));
  }
  return 0.5 * pi * half * sum;
}

template <class Function>
double converged_integral(const Function& f, double low, double high, double whole, int halvings) {
  const double middle = 0.5 * (low + high);
  const double left = integral(f, low, middle), right = integral(f, middle, high);
  if (halvings == most_halvings || std::abs(left + right - whole) < tolerance) return left + right;
  return converged_integral(f, low, middle, left, halvings + 1) +
         converged_integral(f, middle, high, right, halvings + 1);
}

}  // namespace

double sphere_cube_overlap(const Vec3<double>& offset, double radius) {
  const double x = std::abs(offset.x), y = std::abs(offset.y), z = std::abs(offset.z);
  const double squared_radius = radius * radius;
  const auto squared_length = [](double a, double b, double c) { return a * a + b * b + c * c; };
  const auto nearest = [](double a) { return std::max(a - 0.5, 0.0); };
  if (squared_length(nearest(x), nearest(y), nearest(z)) >= squared_radius) return 0;
  if (squared_length(x + 0.5, y + 0.5, z + 0.5) <= squared_radius) return 1;

  const Square square{x - 0.5, x + 0.5, y - 0.5, y + 0.5};
  std::array<double, 20> cut;
  int cuts = 0;
  const double low = std::max(z - 0.5, -radius), high = std::min(z + 0.5, radius);
  cut[cuts++] = low, cut[cuts++] = high;
  for (const double a : {0.0, square.x0, square.x1})
    for (const double b : {0.0, square.y0, square.y1})
      for (const double sign : {-1.0, 1.0}) {
        const double height = sign * std::sqrt(std::max(squared_radius - a * a - b * b, 0.0));
        if (height > low && height < high) cut[cuts++] = height;
      }
  std::sort(cut.begin(), cut.begin() + cuts);

  const auto area = [&](double height) { return square.shared_with_disc(squared_radius - height * height); };
  double volume = 0;
  for (int k = 0; k + 1 < cuts; ++k)
    volume += converged_integral(area, cut[k], cut[k + 1], integral(area, cut[k], cut[k + 1]), 0);
  return volume;
}

}  // namespace stresslet
