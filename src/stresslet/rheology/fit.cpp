#include "stresslet/rheology/fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <unsupported/Eigen/NonLinearOptimization>

#include "stresslet/base/error.hpp"

namespace stresslet {

namespace {

/// Deviations in units of the errors, over the parameters (log(phi_max - largest phi), n) or the first alone.
class Deviations {
 public:
  Deviations(std::span<const ViscosityPoint> points, std::optional<double> exponent)
      : points_(points), exponent_(exponent) {
    for (const ViscosityPoint& p : points_) largest_ = std::max(largest_, p.solid_fraction);
  }

  int inputs() const { return exponent_ ? 1 : 2; }
  int values() const { return int(points_.size()); }
  double maximum(const Eigen::VectorXd& q) const { return largest_ + std::exp(q[0]); }
  double exponent(const Eigen::VectorXd& q) const { return exponent_ ? *exponent_ : q[1]; }

  int operator()(const Eigen::VectorXd& q, Eigen::VectorXd& deviation) const {
    for (int i = 0; i < values(); ++i) {
      const ViscosityPoint& p = points_[std::size_t(i)];
      deviation[i] = (law(p.solid_fraction, q) - p.relative_viscosity) / p.error;
    }
    return 0;
  }

  int df(const Eigen::VectorXd& q, Eigen::MatrixXd& jacobian) const {
    jacobian = gradient(q);
    jacobian.col(0) *= std::exp(q[0]);
    return 0;
  }

  /// Derivatives of the deviations by phi_max and n. [point][parameter]
  Eigen::MatrixXd gradient(const Eigen::VectorXd& q) const {
    Eigen::MatrixXd result(values(), inputs());
    for (int i = 0; i < values(); ++i) {
      const ViscosityPoint& p = points_[std::size_t(i)];
      const double x = p.solid_fraction / maximum(q);
      const double weighted = law(p.solid_fraction, q) / p.error;
      result(i, 0) = -weighted * exponent(q) * x / (maximum(q) * (1 - x));
      if (!exponent_) result(i, 1) = -weighted * std::log1p(-x);
    }
    return result;
  }

  Eigen::VectorXd start() const {
    Eigen::VectorXd best(inputs()), q(inputs());
    double smallest = std::numeric_limits<double>::infinity();
    for (double distance = 1e-4; distance < 2; distance *= 1.2) {
      q[0] = std::log(distance);
      double xx = 0, xy = 0, yy = 0;
      for (const ViscosityPoint& p : points_) {
        const double weight = std::pow(p.relative_viscosity / p.error, 2);
        const double x = -std::log1p(-p.solid_fraction / maximum(q)), y = std::log(p.relative_viscosity);
        xx += weight * x * x, xy += weight * x * y, yy += weight * y * y;
      }
      const double n = exponent_ ? *exponent_ : xy / xx;
      if (!exponent_) q[1] = n;
      const double squares = yy - 2 * n * xy + n * n * xx;
      if (squares < smallest) smallest = squares, best = q;
    }
    return best;
  }

 private:
  double law(double solid_fraction, const Eigen::VectorXd& q) const {
    return std::exp(-exponent(q) * std::log1p(-solid_fraction / maximum(q)));
  }

  std::span<const ViscosityPoint> points_;
  std::optional<double> exponent_;
  double largest_ = 0;
};

void refuse(const char* problem, const char* reason, const char* fix) {
  throw InputError(Complaint{"viscosity fit", problem, reason, fix});
}

void validate(std::span<const ViscosityPoint> points, std::optional<double> exponent) {
  std::set<double> solid_fractions;
  for (const ViscosityPoint& p : points) {
    const bool finite = std::isfinite(p.solid_fraction + p.relative_viscosity + p.error);
    if (!finite || p.solid_fraction <= 0 || p.relative_viscosity <= 1 || p.error <= 0)
      refuse("a point has solid fraction <= 0, viscosity <= 1 or error <= 0",
             "the law is 1 without particles and above 1 with them, and the errors are the weights",
             "leave that point out, or give its error");
    solid_fractions.insert(p.solid_fraction);
  }
  if (solid_fractions.size() < (exponent ? 1u : 2u))
    refuse("there are fewer solid fractions than parameters", "they do not fix the parameters",
           "add points, or impose the exponent");
  if (exponent && !(*exponent > 0 && std::isfinite(*exponent)))
    refuse("the imposed exponent is not positive", "the viscosity grows with the solid fraction",
           "impose one near 2, or none");
}

}  // namespace

double ViscosityFit::relative_viscosity(double solid_fraction) const {
  return std::pow(1 - solid_fraction / maximum_solid_fraction, -exponent);
}

ViscosityFit fit_viscosity(std::span<const ViscosityPoint> points, std::optional<double> exponent) {
  validate(points, exponent);
  Deviations deviations(points, exponent);
  Eigen::VectorXd q = deviations.start();
  // Eigen's solver wants at least as many deviations as parameters, which distinct solid fractions guarantee.
  Eigen::LevenbergMarquardt<Deviations> solver(deviations);
  solver.parameters.ftol = solver.parameters.xtol = 1e-14;
  solver.minimize(q);

  const Eigen::MatrixXd gradient = deviations.gradient(q);
  const Eigen::LDLT<Eigen::MatrixXd> curvature(gradient.transpose() * gradient);
  const Eigen::MatrixXd variance = curvature.solve(Eigen::MatrixXd::Identity(q.size(), q.size()));
  const double maximum = deviations.maximum(q);
  if (!(variance.allFinite() && variance.diagonal().minCoeff() > 0 && variance(0, 0) < maximum * maximum))
    refuse("the points do not fix the largest solid fraction: its error is as large as itself",
           "far below it only the ratio of exponent and largest solid fraction enters",
           "add points at larger solid fractions, or impose the exponent");
  return {.maximum_solid_fraction = maximum,
          .maximum_solid_fraction_error = std::sqrt(variance(0, 0)),
          .exponent = deviations.exponent(q),
          .exponent_error = exponent ? 0.0 : std::sqrt(variance(1, 1)),
          .chi_squared = solver.fvec.squaredNorm(),
          .degrees_of_freedom = deviations.values() - deviations.inputs()};
}

}  // namespace stresslet
