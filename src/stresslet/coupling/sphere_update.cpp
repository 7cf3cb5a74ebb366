#include "stresslet/coupling/sphere_update.hpp"

#include <cmath>

namespace stresslet {

namespace {

/// Clears what a held sphere does not answer to.
void keep_free(Vector6& v, const SphereInertia& inertia) {
  if (!inertia.translates) v.head<3>().setZero();
  if (!inertia.rotates) v.tail<3>().setZero();
}

void keep_free(Matrix6& m, const SphereInertia& inertia) {
  for (int k = 0; k < 6; ++k)
    if (k < 3 ? !inertia.translates : !inertia.rotates) {
      m.row(k).setZero();
      m.col(k).setZero();
      m(k, k) = 1;
    }
}

/// image += resistance velocity.
void apply(const std::vector<SphereLink>& links, const std::vector<Vector6>& velocity, std::vector<Vector6>& image) {
  for (const SphereLink& link : links) {
    Vector12 both;
    both << velocity[std::size_t(link.first)], velocity[std::size_t(link.second)];
    const Vector12 pull = link.resistance * both;
    image[std::size_t(link.first)] += pull.head<6>();
    image[std::size_t(link.second)] += pull.tail<6>();
  }
}

double product(const std::vector<Vector6>& a, const std::vector<Vector6>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].dot(b[k]);
  return sum;
}

}  // namespace

SphereSystem sphere_system(const ExchangeSums& s, const SphereInertia& inertia, const ResolvedSphere& before) {
  const SymTensor3<double> arm = s.rotational() + inertia.moment_of_inertia * identity3<double>();
  const double whole = inertia.mass + s.mass;
  const Vec3<double>& f = s.first;
  SphereSystem system;
  system.matrix << whole, 0, 0, 0, f.z, -f.y,  //
      0, whole, 0, -f.z, 0, f.x,               //
      0, 0, whole, f.y, -f.x, 0,               //
      0, -f.z, f.y, arm.xx, arm.xy, arm.xz,    //
      f.z, 0, -f.x, arm.xy, arm.yy, arm.yz,    //
      -f.y, f.x, 0, arm.xz, arm.yz, arm.zz;
  system.right = stacked(inertia.mass * before.velocity + s.momentum + inertia.force,
                         inertia.moment_of_inertia * before.angular_velocity + inertia.torque + s.angular_momentum());
  return system;
}

SettleReport SphereUpdate::solve(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
                                 const std::vector<SphereLink>& links) {
  const std::size_t n = spheres.size();
  for (auto* v : {&velocity_, &residual_, &direction_, &image_, &preconditioned_}) v->resize(n);
  inverse_.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    inverse_[k] = systems_[k].matrix;
    velocity_[k] = stacked(spheres[k].velocity, spheres[k].angular_velocity);
    image_[k].noalias() = systems_[k].matrix * velocity_[k];
  }
  for (const SphereLink& link : links) {
    inverse_[std::size_t(link.first)] += link.resistance.topLeftCorner<6, 6>();
    inverse_[std::size_t(link.second)] += link.resistance.bottomRightCorner<6, 6>();
    const Vector12 pull = link.resistance.middleCols<3>(6) * Eigen::Vector3d(link.jump.x, link.jump.y, link.jump.z);
    systems_[std::size_t(link.first)].right -= pull.head<6>();
    systems_[std::size_t(link.second)].right -= pull.tail<6>();
  }
  apply(links, velocity_, image_);

  double scale = 0;
  const auto precondition = [&](std::size_t k) {
    keep_free(residual_[k], inertia[k]);
    preconditioned_[k].noalias() = inverse_[k] * residual_[k];
  };
  for (std::size_t k = 0; k < n; ++k) {
    keep_free(inverse_[k], inertia[k]);
    inverse_[k] = Matrix6(inverse_[k].ldlt().solve(Matrix6::Identity()));
    Vector6 right = systems_[k].right;
    keep_free(right, inertia[k]);
    scale += right.dot(inverse_[k] * right);
    residual_[k] = systems_[k].right - image_[k];
    precondition(k);
    direction_[k] = preconditioned_[k];
  }

  SettleReport report;
  double now = product(residual_, preconditioned_);
  const double enough = settle_tolerance * settle_tolerance * scale;
  constexpr int most = 500;
  while (now > enough && report.iterations < most) {
    for (std::size_t k = 0; k < n; ++k) image_[k].noalias() = systems_[k].matrix * direction_[k];
    apply(links, direction_, image_);
    for (std::size_t k = 0; k < n; ++k) keep_free(image_[k], inertia[k]);
    const double length = now / product(direction_, image_);
    for (std::size_t k = 0; k < n; ++k) {
      velocity_[k] += length * direction_[k];
      residual_[k] -= length * image_[k];
      precondition(k);
    }
    const double next = product(residual_, preconditioned_);
    for (std::size_t k = 0; k < n; ++k) direction_[k] = preconditioned_[k] + (next / now) * direction_[k];
    now = next;
    ++report.iterations;
  }
  report.residual = scale > 0 ? std::sqrt(now / scale) : 0;
  for (std::size_t k = 0; k < n; ++k) {
    spheres[k].velocity = {velocity_[k](0), velocity_[k](1), velocity_[k](2)};
    spheres[k].angular_velocity = {velocity_[k](3), velocity_[k](4), velocity_[k](5)};
  }
  return report;
}

}  // namespace stresslet
