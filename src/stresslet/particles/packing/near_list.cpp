#include "stresslet/particles/packing/near_list.hpp"

#include <algorithm>

namespace stresslet {

void NearList::build(const Spheres& spheres, double inflation) {
  const std::size_t n = spheres.size();
  x_ = spheres.x, y_ = spheres.y, z_ = spheres.z;
  inflation_ = inflation;
  grid_.build(spheres.box, x_, y_, z_, inflation * spheres.mean_diameter() + skin_);

  smaller_.clear(), larger_.clear();
  start_.assign(n + 1, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const double a = spheres.radius[i];
    grid_.for_each_candidate(spheres.position(i), 2 * inflation * a + skin_, [&](std::int32_t candidate) {
      const auto j = std::size_t(candidate);
      const double b = spheres.radius[j];
      if (!(b < a || (b == a && j > i))) return;
      const double range = inflation * (a + b) + skin_;
      const Vec3<double> r = spheres.separation(i, j);
      if (dot(r, r) >= range * range) return;
      larger_.push_back(std::int32_t(i)), smaller_.push_back(candidate);
      ++start_[i], ++start_[j];
    });
  }

  std::size_t end = 0;
  for (std::size_t& s : start_) s = end += s;
  neighbour_.resize(end);
  for (std::size_t pair = smaller_.size(); pair-- > 0;) {
    neighbour_[--start_[std::size_t(larger_[pair])]] = smaller_[pair];
    neighbour_[--start_[std::size_t(smaller_[pair])]] = larger_[pair];
  }
}

bool NearList::moved_too_far(const Spheres& spheres, std::size_t i) const {
  const Vec3<double> d = spheres.box.nearest_image(spheres.position(i) - Vec3<double>{x_[i], y_[i], z_[i]}).r;
  return dot(d, d) >= 0.25 * skin_ * skin_;
}

void NearList::update(const Spheres& spheres, double inflation) {
  bool stale = x_.size() != spheres.size() || inflation > inflation_;
  for (std::size_t i = 0; i < spheres.size() && !stale; ++i) stale = moved_too_far(spheres, i);
  if (stale) build(spheres, inflation);
}

}  // namespace stresslet
