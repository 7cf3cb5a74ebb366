#pragma once
/// New velocities of the spheres from the momentum that they exchange with the fluid in this very step,
/// semi-implicit. Of one sphere:
///   (M + m) U + w x s1                       = M U0 + sum m u*       + force
///   s1 x U + (I + sum m (r.r - r r)) w       = I w0 + sum r x m u*   + torque,       s1 = sum m r,
/// with the sums of exchange_sums.hpp: symmetric, positive definite, stable for any weight B < 2 and any density; an
/// explicit update (explicit_update.hpp) is not beyond B = 2/(1 + fluid density/sphere density). Links between spheres
/// add their resistance to the system of all.
#include <vector>

#include "stresslet/coupling/exchange_sums.hpp"
#include "stresslet/coupling/sphere_images.hpp"
#include "stresslet/coupling/sphere_links.hpp"

namespace stresslet {

/// What a sphere is, and what acts on it besides fluid and links, for one step in lattice units.
struct SphereInertia {
  double mass = 0, moment_of_inertia = 0;
  Vec3<double> force{}, torque{};
  bool translates = true, rotates = true;  ///< false: that velocity stays what it is
};

/// M + A of one sphere, and the right-hand side.
struct SphereSystem {
  Matrix6 matrix;
  Vector6 right;
};
SphereSystem sphere_system(const ExchangeSums& sums, const SphereInertia& inertia, const ResolvedSphere& before);

struct SettleReport {
  int iterations = 0;
  double residual = 0;  ///< of the right-hand side, relative
};

/// Conjugate gradients over all spheres, preconditioned by the 6x6 blocks of each with its links; without links one
/// iteration. Ends at a relative residual of `tolerance`: what is left is missing in the sum of momenta.
class SphereUpdate {
 public:
  /// Replaces the velocities of `spheres` by those at the end of the step; `sums(k)` are those of sphere k.
  template <class Sums>
  SettleReport settle(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
                      const std::vector<SphereLink>& links, Sums&& sums) {
    systems_.resize(spheres.size());
    for (std::size_t k = 0; k < spheres.size(); ++k) systems_[k] = sphere_system(sums(k), inertia[k], spheres[k]);
    return solve(spheres, inertia, links);
  }

 private:
  SettleReport solve(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
                     const std::vector<SphereLink>& links);

  std::vector<SphereSystem> systems_;
  std::vector<Matrix6> inverse_;
  std::vector<Vector6> velocity_, residual_, direction_, image_, preconditioned_;
};

constexpr double settle_tolerance = 1e-14;

}  // namespace stresslet
