#pragma once
/// New velocities of the spheres from the forces at their old ones, explicit:
///   M U+ = M U + sum m (u* - U - w x r) + force,   I w+ = I w + sum r x m (u* - U - w x r) + torque,
/// links by the old velocities as well; the sums are those of exchange_sums.hpp. Beside the semi-implicit one
/// (sphere_update.hpp, use that if unsure) it needs no solve, but the spheres must not be light.
///
/// Stability. In the norm of the kinetic energy of spheres and fluid, streaming changes nothing, and the exchange takes
/// off 1 - l of its modes, with l at most
///   l = B + a,   B the largest weight of a cell, a the largest eigenvalue of (exchange + links)/inertia of a sphere
/// (the roots of sum m/(l - B_n) = M over its cells n); l < 2 suffices. Where B is the same in all cells this is
/// B < 2/(1 + fluid density/sphere density).
#include <vector>

#include "stresslet/coupling/sphere_update.hpp"

namespace stresslet {

/// The lightest sphere, over the fluid, for an explicit update with cells of weight `weight`: B/(2 - B).
inline double explicit_density_ratio_limit(double weight) { return weight / (2 - weight); }

class ExplicitUpdate {
 public:
  /// `largest_weight`: B of a solid cell.
  explicit ExplicitUpdate(double largest_weight) : weight_(largest_weight) {}

  /// After the sweep, which met the spheres at the velocities that they still have; `sums(k)` are those of that step.
  /// Throws NumericalFailure where the step is not stable.
  template <class Sums>
  void advance(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
               const std::vector<SphereLink>& links, Sums&& sums) {
    systems_.resize(spheres.size());
    for (std::size_t k = 0; k < spheres.size(); ++k) systems_[k] = sphere_system(sums(k), inertia[k], spheres[k]);
    apply(spheres, inertia, links);
  }

  /// l of the last step, over all spheres; unstable from 2 on.
  double largest_rate() const { return rate_; }

 private:
  void apply(std::vector<ResolvedSphere>& spheres, const std::vector<SphereInertia>& inertia,
             const std::vector<SphereLink>& links);

  double weight_, rate_ = 0;
  std::vector<SphereSystem> systems_;
  std::vector<Matrix6> resistance_;
  std::vector<Vector6> before_;
};

}  // namespace stresslet
