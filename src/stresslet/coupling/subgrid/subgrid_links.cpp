#include "stresslet/coupling/subgrid/subgrid_links.hpp"

#include <stdexcept>

#include "stresslet/coupling/laws.hpp"

namespace stresslet {
namespace {

Eigen::Matrix3d projector(const Vec3<double>& e) {
  Eigen::Matrix3d m;
  m << e.x * e.x, e.x * e.y, e.x * e.z, e.x * e.y, e.y * e.y, e.y * e.z, e.x * e.z, e.y * e.z, e.z * e.z;
  return m;
}

template <class Visit>
void with_law(const SubgridCorrection& correction, Visit&& visit) {
  if (!SubgridLaws::dispatch(correction.law, visit))
    throw std::invalid_argument("unknown sub-grid law " + correction.law);
}

}  // namespace

Matrix12 pair_resistance_matrix(const PairResistance<double>& k, const Vec3<double>& e, double centre_distance) {
  const Eigen::Matrix3d turn = cross_matrix(e), across = Eigen::Matrix3d::Identity() - projector(e),
                        none = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 1, 12> normal;
  normal << -e.x, -e.y, -e.z, 0, 0, 0, e.x, e.y, e.z, 0, 0, 0;
  // v_t = P u - R w_s x e = P u + R e x w_s, and w_d x e = -e x w_d.
  Eigen::Matrix<double, 3, 12> sliding, counter_spin;
  sliding << -across, 0.5 * centre_distance * turn, across, 0.5 * centre_distance * turn;
  counter_spin << none, -0.5 * turn, none, 0.5 * turn;
  Matrix12 r = k.X * normal.transpose() * normal;
  r += k.Y * sliding.transpose() * sliding + k.C * counter_spin.transpose() * counter_spin;
  r += k.B * (sliding.transpose() * counter_spin + counter_spin.transpose() * sliding);
  return r;
}

Matrix6 wall_resistance_matrix(const PairResistance<double>& k, const Vec3<double>& e) {
  const Eigen::Matrix3d turn = cross_matrix(e), along = projector(e), across = Eigen::Matrix3d::Identity() - along;
  Matrix6 r;
  r << k.X * along + k.Y * across, -k.B * turn, k.B * turn, k.C * across;
  return r;
}

std::optional<SphereLink> subgrid_link(const std::vector<ResolvedSphere>& spheres, std::int32_t first,
                                       std::int32_t second, const ImageShift& image, double dynamic_viscosity,
                                       const SubgridCorrection& correction) {
  const ResolvedSphere &one = spheres[std::size_t(first)], &two = spheres[std::size_t(second)];
  const Vec3<double> arm = two.centre + image.displacement - one.centre;
  const double distance = norm(arm), gap = distance - one.radius - two.radius;
  if (gap >= correction.range.outer) return std::nullopt;
  PairResistance<double> k;
  with_law(correction, [&](auto law) {
    k = subgrid_resistance<typename decltype(law)::type>(one.radius, two.radius, gap, correction.lengths,
                                                         correction.range);
  });
  return SphereLink{first, second, dynamic_viscosity * pair_resistance_matrix(k, arm / distance, distance),
                    image.velocity};
}

std::optional<Matrix6> subgrid_wall_resistance_matrix(double radius, const Vec3<double>& e, double gap,
                                                      double dynamic_viscosity, const SubgridCorrection& correction) {
  if (gap >= correction.range.outer) return std::nullopt;
  PairResistance<double> k;
  with_law(correction, [&](auto law) {
    k = subgrid_wall_resistance<typename decltype(law)::type>(radius, gap, correction.lengths_at_walls(),
                                                              correction.range);
  });
  return dynamic_viscosity * wall_resistance_matrix(k, e);
}

Vec3<double> link_force(const SphereLink& link, const std::vector<ResolvedSphere>& spheres) {
  const ResolvedSphere &one = spheres[std::size_t(link.first)], &two = spheres[std::size_t(link.second)];
  const Vec3<double> u = two.velocity + link.jump;
  const Vec3<double>&w1 = one.angular_velocity, &w2 = two.angular_velocity;
  Vector12 v;
  v << one.velocity.x, one.velocity.y, one.velocity.z, w1.x, w1.y, w1.z, u.x, u.y, u.z, w2.x, w2.y, w2.z;
  const Vector12 f = -link.resistance * v;
  return {f(0), f(1), f(2)};
}

}  // namespace stresslet
