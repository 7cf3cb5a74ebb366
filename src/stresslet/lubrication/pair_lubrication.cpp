#include "stresslet/lubrication/pair_lubrication.hpp"

#include "stresslet/lubrication/laws.hpp"

namespace stresslet {

void PairLubrication::prepare(std::size_t capacity) {
  for (auto* a : {&X_, &Y_, &B_, &C_, &arm_, &background_x_}) a->assign(padded(capacity), 0.0);
  on_first_.resize(padded(capacity)), on_second_.resize(padded(capacity));
}

template <class Law>
void PairLubrication::update_range(Range range, const LubricationCutoffs& cutoffs, const ActivePairs& pairs,
                                   const Box& box) {
  const Pack zero = 0.0;
  for (std::size_t p = range.begin; p < range.end; p += pack_width) {
    const Pack a1 = load(&pairs.radius_i[p]), a2 = load(&pairs.radius_j[p]), gap = load(&pairs.gap[p]);
    const Pack effective = effective_diameter(a1, a2);
    const auto apart = gap > cutoffs.outer * effective;
    const Pack film =
        select(apart, Pack(cutoffs.outer * effective), Pack(stdx::max(gap, Pack(cutoffs.inner * effective))));
    const PairResistance<Pack> k = Law::resistance(a1, a2, film);
    store(&X_[p], select(apart, zero, k.X));
    store(&Y_[p], select(apart, zero, k.Y));
    store(&B_[p], select(apart, zero, k.B));
    store(&C_[p], select(apart, zero, k.C));
    store(&arm_[p], Law::arm(a1, a2, load(&pairs.distance[p])));
    Pack across = -load(&pairs.images_up[p]) * box.velocity_jump();
    if constexpr (Law::sees_background) across -= gap * box.mean_gradient() * load(&pairs.ey[p]);
    store(&background_x_[p], across);
  }
}

void PairLubrication::update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs,
                             const ActivePairs& pairs, const Box& box) {
  LubricationLaws::dispatch(law, [&](auto tag) {
    update_range<typename decltype(tag)::type>(member.share(padded(pairs.size()), pack_width), cutoffs, pairs, box);
  });
  member.barrier();
}

template <bool background>
void PairLubrication::apply(Member& member, const ActivePairs& pairs, const TwistVector& twist) {
  const Range range = member.share(padded(pairs.size()), pack_width);
  for (std::size_t p = range.begin; p < range.end; p += pack_width) {
    const Twist<Pack> t1 = twist.gather(&pairs.i[p]), t2 = twist.gather(&pairs.j[p]);
    PairMotion<Pack> motion{t2.linear - t1.linear, t1.angular, t2.angular};
    if constexpr (background) motion.u.x += load(&background_x_[p]);
    const PairResistance<Pack> k{load(&X_[p]), load(&Y_[p]), load(&B_[p]), load(&C_[p])};
    const PairWrench<Pack> w = pair_wrench(pairs.normal_pack(p), load(&arm_[p]), k, motion);
    on_first_.scatter(p, w.force, w.half_sum - w.half_difference);
    on_second_.scatter(p, -w.force, w.half_sum + w.half_difference);
  }
  member.barrier();
}

template void PairLubrication::apply<true>(Member&, const ActivePairs&, const TwistVector&);
template void PairLubrication::apply<false>(Member&, const ActivePairs&, const TwistVector&);

}  // namespace stresslet
