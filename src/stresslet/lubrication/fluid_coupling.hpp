#pragma once
/// What a resolved fluid does to the particles within one step, as the velocity solve needs it: linear in their
/// velocities, symmetric and never driving. Empty where the fluid is not resolved. Units of the particles.
#include <cstdint>
#include <vector>

#include "stresslet/base/vec3.hpp"
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

class FluidCoupling {
 public:
  std::vector<ExchangeResistance> resistance;  ///< per particle
  std::vector<Twist<double>> push;             ///< force and torque on a particle at rest

  bool present() const { return !resistance.empty(); }
  const std::vector<PointFriction>& friction() const { return friction_; }

  void set_friction(std::vector<PointFriction> friction, std::size_t particles) {
    friction_ = std::move(friction);
    first_.assign(particles + 1, 0);
    for (const PointFriction& f : friction_) ++first_[std::size_t(f.first) + 1], ++first_[std::size_t(f.second) + 1];
    for (std::size_t i = 0; i < particles; ++i) first_[i + 1] += first_[i];
    end_.resize(2 * friction_.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t k = 0; k < friction_.size(); ++k) {
      end_[next[std::size_t(friction_[k].first)]++] = {k, true};
      end_[next[std::size_t(friction_[k].second)]++] = {k, false};
    }
  }

  /// The particle's velocity counts from another frame, faster by -`change`: what acts on it stays the same.
  void change_frame(std::size_t i, const Vec3<double>& change) {
    push[i].linear += resistance[i].linear * change;
    push[i].angular += cross(resistance[i].offset, change);
    for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k)
      friction_[end_[k].friction].jump += end_[k].is_first ? change : -change;
  }

  /// Calls `visit(friction, whether the particle comes first)`.
  template <class Visit>
  void for_each_friction_of(std::size_t particle, Visit&& visit) const {
    if (friction_.empty()) return;
    for (std::uint32_t k = first_[particle]; k < first_[particle + 1]; ++k)
      visit(friction_[end_[k].friction], end_[k].is_first);
  }

  /// Adds the wrench on one particle: with `background` what the fluid really exerts, without, the linear part.
  template <bool background>
  void add_to(std::size_t i, const TwistVector& velocity, Twist<double>& wrench) const {
    if (!present()) return;
    const ExchangeResistance& e = resistance[i];
    const Twist<double> v = velocity.get(i);
    wrench.linear -= e.linear * v.linear + cross(v.angular, e.offset);
    wrench.angular -= cross(e.offset, v.linear) + e.angular * v.angular;
    if constexpr (background) wrench.linear += push[i].linear, wrench.angular += push[i].angular;
    for_each_friction_of(i, [&](const PointFriction& f, bool is_first) {
      const Vec3<double> force =
          f.force(velocity.get(std::size_t(f.first)), velocity.get(std::size_t(f.second)), background);
      if (is_first)
        wrench.linear += force, wrench.angular += cross(f.arm_first, force);
      else
        wrench.linear -= force, wrench.angular -= cross(f.arm_second, force);
    });
  }

  /// Adds the particle's diagonal blocks.
  void add_diagonal(std::size_t i, SymTensor3<double>& linear, SymTensor3<double>& angular) const {
    if (!present()) return;
    linear += resistance[i].linear * identity3<double>();
    angular += resistance[i].angular;
    for_each_friction_of(i, [&](const PointFriction& f, bool is_first) {
      const Vec3<double>& arm = is_first ? f.arm_first : f.arm_second;
      linear += f.coefficient * identity3<double>();
      angular += f.coefficient * (dot(arm, arm) * identity3<double>() - square(arm));
    });
  }

 private:
  struct End {
    std::uint32_t friction;
    bool is_first;
  };
  std::vector<PointFriction> friction_;
  std::vector<std::uint32_t> first_;
  std::vector<End> end_;
};

}  // namespace stresslet
