#include "stresslet/particles/verlet_list.hpp"

#include <algorithm>
#include <cmath>

namespace stresslet {

void VerletList::build(ThreadTeam& team, const ParticleState& state, const Box& box) {
  const std::size_t n = state.size();
  std::vector<std::vector<std::int32_t>> found_i(std::size_t(team.size())), found_j(std::size_t(team.size()));
  team.run([&](Member& member) {
    auto& mine_i = found_i[std::size_t(member.rank())];
    auto& mine_j = found_j[std::size_t(member.rank())];
    const Range range = member.share(n);
    for (std::size_t a = range.begin; a < range.end; ++a)
      for (std::size_t b = a + 1; b < n; ++b) {
        const double reach =
            state.radius[a] + state.radius[b] + range_(state.radius[a], state.radius[b]) + skin_;
        const Vec3<double> r = box.nearest_image(state.position(b) - state.position(a)).r;
        if (dot(r, r) < reach * reach) mine_i.push_back(std::int32_t(a)), mine_j.push_back(std::int32_t(b));
      }
  });
  i.clear(), j.clear();
  for (std::size_t t = 0; t < found_i.size(); ++t) {
    i.insert(i.end(), found_i[t].begin(), found_i[t].end());
    j.insert(j.end(), found_j[t].begin(), found_j[t].end());
  }
  const double a = n ? *std::max_element(state.radius.begin(), state.radius.end()) : 0.0;
  largest_distance_ = 2 * a + range_(a, a) + skin_;
}

}  // namespace stresslet
