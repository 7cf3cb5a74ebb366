#include "stresslet/simulation/snapshot.hpp"

#include <algorithm>
#include <numeric>

namespace stresslet {

Snapshot make_snapshot(const Suspension& s) {
  const ParticleState& state = s.state;
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return state.id[a] < state.id[b]; });

  Snapshot snapshot;
  snapshot.strain = snapshot.time = s.strain;
  snapshot.box = {{s.box.length.x, s.box.length.y, s.box.length.z}, s.box.offset, s.box.periodic_in_y()};
  const auto append = [](std::vector<double>& rows, const Vec3<double>& v) {
    rows.insert(rows.end(), {v.x, v.y, v.z});
  };
  for (std::size_t i : order) {
    append(snapshot.position, state.position(i));
    append(snapshot.velocity, state.velocity(i));
    append(snapshot.angular_velocity, state.angular_velocity(i));
    snapshot.radius.push_back(state.radius[i]);
    snapshot.species.push_back(state.species[i]);
    snapshot.id.push_back(state.id[i]);
  }
  return snapshot;
}

}  // namespace stresslet
