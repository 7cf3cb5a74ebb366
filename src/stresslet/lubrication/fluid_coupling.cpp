#include "stresslet/lubrication/fluid_coupling.hpp"

#include <utility>

namespace stresslet {

void FluidCoupling::set_friction(std::vector<PointFriction> friction, std::size_t particles) {
  friction_ = std::move(friction);
  const std::size_t n = friction_.size(), whole_packs = padded(n);
  first_.assign(particles + 1, 0);
  for (const PointFriction& f : friction_) ++first_[std::size_t(f.first) + 1], ++first_[std::size_t(f.second) + 1];
  for (std::size_t i = 0; i < particles; ++i) first_[i + 1] += first_[i];
  end_.resize(2 * n);
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t k = 0; k < n; ++k) {
    end_[next[std::size_t(friction_[k].first)]++] = {k, true};
    end_[next[std::size_t(friction_[k].second)]++] = {k, false};
  }

  if (on_first_.size() < whole_packs) on_first_.resize(whole_packs), on_second_.resize(whole_packs);
  Packed& p = packed_;
  p.first.resize(whole_packs), p.second.resize(whole_packs), p.coefficient.resize(whole_packs);
  for (std::size_t k = 0; k < whole_packs; ++k) {
    p.first[k] = k < n ? friction_[k].first : 0, p.second[k] = k < n ? friction_[k].second : 0;
    p.coefficient[k] = k < n ? friction_[k].coefficient : 0;
  }
  const auto pack = [&](std::array<AlignedVector<double>, 3>& rows, Vec3<double> PointFriction::*vector) {
    for (auto& row : rows) row.resize(whole_packs);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec3<double>& v = friction_[k].*vector;
      rows[0][k] = v.x, rows[1][k] = v.y, rows[2][k] = v.z;
    }
  };
  pack(p.arm_first, &PointFriction::arm_first);
  pack(p.arm_second, &PointFriction::arm_second);
  pack(p.jump, &PointFriction::jump);
}

void FluidCoupling::change_frame(std::size_t i, const Vec3<double>& change) {
  push[i].linear += resistance[i].linear * change;
  push[i].angular += cross(resistance[i].offset, change);
  for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
    const std::size_t f = end_[k].friction;
    Vec3<double>& jump = friction_[f].jump;
    jump += end_[k].is_first ? change : -change;
    packed_.jump[0][f] = jump.x, packed_.jump[1][f] = jump.y, packed_.jump[2][f] = jump.z;
  }
}

template <bool background>
void FluidCoupling::apply(Member& member, const TwistVector& twist) {
  if (friction_.empty()) return;
  const auto at = [](const std::array<AlignedVector<double>, 3>& rows, std::size_t k) {
    return Vec3<Pack>{load(&rows[0][k]), load(&rows[1][k]), load(&rows[2][k])};
  };
  const Range mine = member.share(padded(friction_.size()), pack_width);
  for (std::size_t k = mine.begin; k < mine.end; k += pack_width) {
    const Twist<Pack> v1 = twist.gather(&packed_.first[k]), v2 = twist.gather(&packed_.second[k]);
    const Vec3<Pack> arm1 = at(packed_.arm_first, k), arm2 = at(packed_.arm_second, k);
    Vec3<Pack> u = v2.linear - v1.linear + cross(v2.angular, arm2) - cross(v1.angular, arm1);
    if constexpr (background) u += at(packed_.jump, k);
    const Vec3<Pack> force = load(&packed_.coefficient[k]) * u;
    on_first_.scatter(k, force, cross(arm1, force));
    on_second_.scatter(k, -force, -cross(arm2, force));
  }
  member.barrier();
}

void FluidCoupling::add_diagonal(std::size_t i, SymTensor3<double>& linear, SymTensor3<double>& angular) const {
  if (!present()) return;
  linear += resistance[i].linear * identity3<double>();
  angular += resistance[i].angular;
  if (friction_.empty()) return;
  for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k) {
    const PointFriction& f = friction_[end_[k].friction];
    const Vec3<double>& arm = end_[k].is_first ? f.arm_first : f.arm_second;
    linear += f.coefficient * identity3<double>();
    angular += f.coefficient * (dot(arm, arm) * identity3<double>() - square(arm));
  }
}

template void FluidCoupling::apply<true>(Member&, const TwistVector&);
template void FluidCoupling::apply<false>(Member&, const TwistVector&);

}  // namespace stresslet
