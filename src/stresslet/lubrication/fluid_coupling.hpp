#pragma once
/// What a resolved fluid does to the particles within one step, as the velocity solve needs it: linear in their
/// velocities, symmetric and never driving. Empty where the fluid is not resolved. Units of the particles.
#include <array>
#include <cstdint>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/exec/aligned.hpp"
#include "stresslet/exec/thread_team.hpp"
#include "stresslet/particles/twist.hpp"

namespace stresslet {

/// Resistance of one particle to the fluid around it, about a centre that its hold on the fluid need not share:
/// force = linear U + w x offset, torque = offset x U + angular w.
struct ExchangeResistance {
  double linear = 0;
  Vec3<double> offset{};
  SymTensor3<double> angular{};
};

/// Friction between two spheres that hold the same fluid: c (u2 - u1) acts on the first, the opposite on the second,
/// at one point, with u the rigid velocities there.
struct PointFriction {
  std::int32_t first, second;
  double coefficient;
  Vec3<double> arm_first, arm_second;  ///< from the centres to the point
  Vec3<double> jump;                   ///< velocity of the image of `second` that meets `first`, less that of `second`

  /// On the first; `background` includes the jump.
  Vec3<double> force(const Twist<double>& v1, const Twist<double>& v2, bool background) const {
    const Vec3<double> u = v2.linear - v1.linear + cross(v2.angular, arm_second) - cross(v1.angular, arm_first);
    return coefficient * (background ? u + jump : u);
  }
};

/// `apply`, the hot loop, per friction: reads 80 B of geometry (88 B with `background`), 8 B of indices and two twists
/// (128 B, mostly from cache), writes wrenches of 128 B, 57 flops.
class FluidCoupling {
 public:
  std::vector<ExchangeResistance> resistance;  ///< per particle
  std::vector<Twist<double>> push;             ///< force and torque on a particle at rest

  bool present() const { return !resistance.empty(); }
  const std::vector<PointFriction>& friction() const { return friction_; }

  void set_friction(std::vector<PointFriction> friction, std::size_t particles);

  /// The particle's velocity counts from another frame, faster by -`change`: what acts on it stays the same.
  void change_frame(std::size_t i, const Vec3<double>& change);

  /// Wrenches of all frictions for the given twists: with `background` what really acts, without, the linear part.
  /// All threads; ends with a barrier.
  template <bool background>
  void apply(Member& member, const TwistVector& twist);

  /// Adds the wrench on one particle: that of the last `apply` and, for its twist `v`, that of the fluid around it.
  template <bool background>
  void add_to(std::size_t i, const Twist<double>& v, Twist<double>& wrench) const {
    if (!present()) return;
    const ExchangeResistance& e = resistance[i];
    wrench.linear -= e.linear * v.linear + cross(v.angular, e.offset);
    wrench.angular -= cross(e.offset, v.linear) + e.angular * v.angular;
    if constexpr (background) wrench.linear += push[i].linear, wrench.angular += push[i].angular;
    if (friction_.empty()) return;
    RowSum sum(wrench);
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k)
      sum.add((end_[k].is_first ? on_first_ : on_second_)[end_[k].friction]);
    wrench = sum.twist();
  }

  /// Adds the particle's diagonal blocks.
  void add_diagonal(std::size_t i, SymTensor3<double>& linear, SymTensor3<double>& angular) const;

 private:
  struct End {
    std::uint32_t friction;
    bool is_first;
  };
  std::vector<PointFriction> friction_;
  std::vector<std::uint32_t> first_;
  std::vector<End> end_;

  // The frictions once more for `apply`, padded to whole packs by some without strength, of particle 0 with itself.
  struct Packed {
    AlignedVector<std::int32_t> first, second;
    AlignedVector<double> coefficient;
    std::array<AlignedVector<double>, 3> arm_first, arm_second, jump;
  } packed_;
  TwistVector on_first_, on_second_;  ///< [friction]
};

}  // namespace stresslet
