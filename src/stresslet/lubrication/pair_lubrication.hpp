#pragma once
/// Pair lubrication kernel: resistance coefficients of all active pairs, and the wrenches they exert for given twists.
///
/// `apply` is the hot loop of every time scheme. Per pair it reads 9 coefficients and geometry values (72 B), 8 B of
/// indices and two twists (128 B, mostly from cache), writes a wrench (72 B) and does about 130 flops; up to some 1e5
/// particles the data stay in cache and the gather of twists bounds it.
#include <string>

#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lubrication/cutoffs.hpp"
#include "stresslet/lubrication/pair_law.hpp"
#include "stresslet/particles/active_pairs.hpp"
#include "stresslet/particles/twist.hpp"

namespace stresslet {

class PairLubrication {
 public:
  void prepare(std::size_t capacity);

  /// Coefficients at the present positions. `law` is a name in LubricationLaws. All threads; ends with a barrier.
  void update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs, const ActivePairs& pairs,
              const Box& box);

  /// Wrench of every pair for the given twists: with `background` the relative velocity of images and the law's
  /// fluid velocity across the gap are included (the physical wrench), without they are not (the linear operator).
  /// All threads; ends with a barrier.
  template <bool background>
  void apply(Member& member, const ActivePairs& pairs, const TwistVector& twist);

  /// Adds the wrench on one particle of the last `apply`.
  void add_to(std::size_t particle, const ActivePairs& pairs, Twist<double>& wrench) const {
    pairs.for_each_pair_of(particle, [&](std::size_t p, double sign) {
      constexpr std::size_t W = pack_width;
      const double* w = &wrench_[wrench_size * (p - p % W) + p % W];
      wrench.linear += sign * Vec3<double>{w[0], w[W], w[2 * W]};
      wrench.angular += Vec3<double>{w[3 * W], w[4 * W], w[5 * W]} - sign * Vec3<double>{w[6 * W], w[7 * W], w[8 * W]};
    });
  }

  PairResistance<double> resistance(std::size_t p) const { return {X_[p], Y_[p], B_[p], C_[p]}; }
  double arm(std::size_t p) const { return arm_[p]; }
  /// Velocity in x that is added to u_j - u_i.
  double background_velocity(std::size_t p) const { return background_x_[p]; }

 private:
  static constexpr std::size_t wrench_size = 9;

  template <class Law>
  void update_range(Range range, const LubricationCutoffs& cutoffs, const ActivePairs& pairs, const Box& box);

  AlignedVector<double> X_, Y_, B_, C_, arm_, background_x_;
  /// Per pair the force on i, half sum and half difference of the torques; nine packs for each pack of pairs.
  AlignedVector<double> wrench_;
};

}  // namespace stresslet
