#pragma once
/// Lubrication of every sphere with the nearer of the two flat walls at y = 0 and y = length.y.
///
/// The cut-offs are those of a pair whose second sphere is infinitely large: d_eff = 2 a.
#include <string>
#include <vector>

#include "stresslet/exec/thread_team.hpp"
#include "stresslet/lubrication/cutoffs.hpp"
#include "stresslet/lubrication/wall.hpp"
#include "stresslet/particles/box.hpp"
#include "stresslet/particles/state.hpp"
#include "stresslet/particles/twist.hpp"

namespace stresslet {

struct WallFilm {
  double normal_y = 0;  ///< -1: wall at y = 0, +1: wall at y = length.y, 0: no wall in reach
  double gap = 0;
  double wall_velocity = 0;
  PairResistance<double> k;

  Vec3<double> normal() const { return {0, normal_y, 0}; }
};

class WallFilms {
 public:
  void prepare(std::size_t particles, const Box& box) {
    films_.assign(particles, {});
    present_ = box.kind == BoxKind::walls;
  }

  /// Whether the box has walls at all.
  bool present() const { return present_; }

  /// All threads; ends with a barrier. Does nothing in boxes without walls.
  void update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs, const ParticleState& state,
              const Box& box);

  /// The same with a law of resistance(a, gap), for gaps below `reach(a)`.
  template <class Reach, class Law>
  void update_with(Member& member, const ParticleState& state, const Box& box, Reach&& reach, Law&& law) {
    if (present_) {
      const Range range = member.share(state.size());
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const double a = state.radius[i];
        const bool upper = state.y[i] > 0.5 * box.length.y;
        const double gap = (upper ? box.length.y - state.y[i] : state.y[i]) - a;
        films_[i] = {};
        if (gap > reach(a)) continue;
        films_[i] = {upper ? 1.0 : -1.0, gap, box.mean_flow(upper ? box.length.y : 0.0), law(a, gap)};
      }
    }
    member.barrier();
  }

  const WallFilm& operator[](std::size_t particle) const { return films_[particle]; }

  /// Adds the wall's wrench on a sphere moving with `t`; without `background` the wall is taken at rest.
  template <bool background>
  void add_to(std::size_t particle, const Twist<double>& t, Twist<double>& wrench) const {
    const WallFilm& film = films_[particle];
    if (film.normal_y == 0) return;
    Vec3<double> u = -t.linear;
    if constexpr (background) u.x += film.wall_velocity;
    const auto w = wall_wrench(film.normal(), film.k, u, t.angular);
    wrench.linear += w.force;
    wrench.angular += w.torque;
  }

 private:
  std::vector<WallFilm> films_;
  bool present_ = false;
};

}  // namespace stresslet
