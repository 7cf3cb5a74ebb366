#include "stresslet/coupling/explicit_update.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "stresslet/base/error.hpp"

namespace stresslet {

namespace {

Vector6 diagonal(const SphereInertia& inertia) {
  Vector6 v;
  v << Eigen::Vector3d::Constant(inertia.mass), Eigen::Vector3d::Constant(inertia.moment_of_inertia);
  return v;
}

/// Largest eigenvalue of resistance/inertia over what the sphere is free to do.
double largest_rate_of(const Matrix6& resistance, const SphereInertia& inertia) {
  Vector6 scale = diagonal(inertia).cwiseSqrt().cwiseInverse();
  if (!inertia.translates) scale.head<3>().setZero();
  if (!inertia.rotates) scale.tail<3>().setZero();
  const Matrix6 scaled = scale.asDiagonal() * resistance * scale.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Matrix6>(scaled, Eigen::EigenvaluesOnly).eigenvalues()(5);
}

[[noreturn]] void refuse(std::size_t sphere, double rate, double weight) {
  const std::string denser = weight < 2 ? fmt::format("density ratio above {:.3g} for a solid weight of {:.3g}",
                                                      explicit_density_ratio_limit(weight), weight)
                                        : "solid weight below 2";
  throw NumericalFailure(
      {"", fmt::format("sphere {}: an explicit update would not be stable, rate {:.3g} per step", sphere, rate),
       fmt::format("the limit is 2: solid weight below 2/(1 + fluid density/sphere density), that is, {}, and less "
                   "where films or shared cells resist",
                   denser),
       "use the semi-implicit update, a denser sphere, or a weight that is smaller (linear)"});
}

}  // namespace

void ExplicitUpdate::apply(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
                           const std::vector<SphereLink>& links) {
  const std::size_t n = spheres.size();
  before_.resize(n);
  resistance_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    before_[k] = stacked(spheres[k].velocity, spheres[k].angular_velocity);
    resistance_[k] = systems_[k].matrix;
    resistance_[k].diagonal() -= diagonal(inertia[k]);
    systems_[k].right -= systems_[k].matrix * before_[k];
  }
  for (const SphereLink& link : links) {
    const std::size_t i = std::size_t(link.first), j = std::size_t(link.second);
    Vector12 both;
    both << before_[i], before_[j];
    both.segment<3>(6) += Eigen::Vector3d(link.jump.x, link.jump.y, link.jump.z);
    const Vector12 pull = link.resistance * both;
    systems_[i].right -= pull.head<6>();
    systems_[j].right -= pull.tail<6>();
    // A link is at most twice its diagonal blocks.
    resistance_[i] += 2 * link.resistance.topLeftCorner<6, 6>();
    resistance_[j] += 2 * link.resistance.bottomRightCorner<6, 6>();
  }
  rate_ = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!inertia[k].translates && !inertia[k].rotates) continue;
    const double rate = weight_ + largest_rate_of(resistance_[k], inertia[k]);
    if (!(rate < 2)) refuse(k, rate, weight_);
    rate_ = std::max(rate_, rate);
  }
  for (std::size_t k = 0; k < n; ++k) {
    const Vector6 change = systems_[k].right.cwiseQuotient(diagonal(inertia[k]));
    if (inertia[k].translates) spheres[k].velocity += Vec3<double>{change(0), change(1), change(2)};
    if (inertia[k].rotates) spheres[k].angular_velocity += Vec3<double>{change(3), change(4), change(5)};
  }
}

}  // namespace stresslet
