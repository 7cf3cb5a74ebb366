#include "stresslet/lubrication/wall_films.hpp"

#include <algorithm>

#include "stresslet/lubrication/laws.hpp"

namespace stresslet {

void WallFilms::update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs,
                       const ParticleState& state, const Box& box) {
  if (present_) {
    const Range range = member.share(state.size());
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const double a = state.radius[i];
      const bool upper = state.y[i] > 0.5 * box.length.y;
      const double gap = (upper ? box.length.y - state.y[i] : state.y[i]) - a;
      WallFilm& film = films_[i];
      film = {};
      if (gap > cutoffs.outer * 2 * a) continue;
      film.normal_y = upper ? 1 : -1;
      film.gap = gap;
      film.wall_velocity = box.mean_flow(upper ? box.length.y : 0.0);
      if (law == NoLubrication::name) continue;
      film.k = wall_resistance(a, std::max(gap, cutoffs.inner * 2 * a));
      if (law == NormalOnly::name) film.k = {film.k.X, 0, 0, 0};
    }
  }
  member.barrier();
}

}  // namespace stresslet
