#include "stresslet/particles/verlet_list.hpp"

#include <algorithm>

namespace stresslet {

void VerletList::set_largest_distance(const ParticleState& state) {
  const double largest = state.size() ? *std::max_element(state.radius.begin(), state.radius.end()) : 0.0;
  largest_distance_ = 2 * largest + range_(largest, largest) + skin_;
}

void VerletList::build(ThreadTeam& team, const ParticleState& state, const Box& box) {
  const std::size_t n = state.size();
  set_largest_distance(state);
  const double largest = *std::max_element(state.radius.begin(), state.radius.end());
  grid_.build(box, state.x, state.y, state.z, 0.5 * largest_distance_);

  std::vector<std::vector<std::int32_t>> found_i(std::size_t(team.size())), found_j(std::size_t(team.size()));
  team.run([&](Member& member) {
    auto& mine_i = found_i[std::size_t(member.rank())];
    auto& mine_j = found_j[std::size_t(member.rank())];
    std::vector<std::int32_t> neighbours;
    const Range particles = member.share(n);
    for (std::size_t a = particles.begin; a < particles.end; ++a) {
      const double radius = state.radius[a];
      const Vec3<double> x = state.position(a);
      neighbours.clear();
      grid_.for_each_candidate(x, radius + largest + range_(radius, largest) + skin_, [&](std::int32_t b) {
        if (b <= std::int32_t(a)) return;
        const double other = state.radius[std::size_t(b)];
        const double reach = radius + other + range_(radius, other) + skin_;
        const Vec3<double> r = box.nearest_image(state.position(std::size_t(b)) - x).r;
        if (dot(r, r) < reach * reach) neighbours.push_back(b);
      });
      std::sort(neighbours.begin(), neighbours.end());
      mine_i.insert(mine_i.end(), neighbours.size(), std::int32_t(a));
      mine_j.insert(mine_j.end(), neighbours.begin(), neighbours.end());
    }
  });
  i.clear(), j.clear();
  for (std::size_t t = 0; t < found_i.size(); ++t) {
    i.insert(i.end(), found_i[t].begin(), found_i[t].end());
    j.insert(j.end(), found_j[t].begin(), found_j[t].end());
  }
}

}  // namespace stresslet
