#pragma once
/// Pair lubrication kernel: resistance coefficients of all active pairs, and the wrenches they exert for given twists.
///
/// `update`, per pair: reads gap, distance, radii and image of the pair (40 B), writes 48 B, about 90 flops with one
/// logarithm; bound by arithmetic. `apply`, the hot loop of every time scheme, per pair: reads 8 coefficients and
/// geometry values (64 B; 72 B with `background`), 8 B of indices and two twists (128 B, mostly from cache), writes a
/// wrench (72 B), 100 flops.
#include <string>

#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lubrication/cutoffs.hpp"
#include "stresslet/lubrication/pair_law.hpp"
#include "stresslet/particles/active_pairs.hpp"
#include "stresslet/particles/twist.hpp"

namespace stresslet {

class PairLubrication {
 public:
  static constexpr double wrench_bytes = 128;
  static constexpr double bytes_per_pair = 72 + wrench_bytes;  ///< of apply<false>, twists in cache
  static constexpr double flops_per_pair = 106;                ///< of apply<false>

  void prepare(std::size_t capacity);

  /// Coefficients at the present positions. `law` is a name in LubricationLaws. All threads; ends with a barrier.
  void update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs, const ActivePairs& pairs,
              const Box& box);

  /// The same from `film(a1, a2, gap)`, a PairResistance<Pack> per unit viscosity, for laws with parameters.
  template <class Film>
  void update_with(Member& member, const ActivePairs& pairs, const Box& box, Film&& film) {
    const Range mine = member.share(padded(pairs.size()), pack_width);
    for (std::size_t p = mine.begin; p < mine.end; p += pack_width) {
      const PairResistance<Pack> k = film(load(&pairs.radius_i[p]), load(&pairs.radius_j[p]), load(&pairs.gap[p]));
      store(&X_[p], k.X), store(&Y_[p], k.Y), store(&B_[p], k.B), store(&C_[p], k.C);
      store(&arm_[p], load(&pairs.distance[p]));
      store(&background_x_[p], -load(&pairs.images_up[p]) * box.velocity_jump());
    }
    member.barrier();
  }

  /// Wrench of every pair for the given twists: with `background` the relative velocity of images and the law's
  /// fluid velocity across the gap are included (the physical wrench), without they are not (the linear operator).
  /// All threads; ends with a barrier.
  template <bool background>
  void apply(Member& member, const ActivePairs& pairs, const TwistVector& twist);

  /// Adds the wrench on one particle of the last `apply`.
  void add_to(std::size_t particle, const ActivePairs& pairs, Twist<double>& wrench) const {
    RowSum sum(wrench);
    pairs.for_each_pair_of(particle,
                           [&](std::size_t p, double sign) { sum.add((sign > 0 ? on_first_ : on_second_)[p]); });
    wrench = sum.twist();
  }

  PairResistance<double> resistance(std::size_t p) const { return {X_[p], Y_[p], B_[p], C_[p]}; }
  double arm(std::size_t p) const { return arm_[p]; }
  /// Velocity in x that is added to u_j - u_i.
  double background_velocity(std::size_t p) const { return background_x_[p]; }

 private:
  template <class Law>
  void update_range(Range range, const LubricationCutoffs& cutoffs, const ActivePairs& pairs, const Box& box);

  AlignedVector<double> X_, Y_, B_, C_, arm_, background_x_;
  TwistVector on_first_, on_second_;  ///< [pair] force and torque on i and on j
};

}  // namespace stresslet
