#include "stresslet/lubrication/wall_films.hpp"

#include <algorithm>

#include "stresslet/lubrication/laws.hpp"

namespace stresslet {

void WallFilms::update(Member& member, const std::string& law, const LubricationCutoffs& cutoffs,
                       const ParticleState& state, const Box& box) {
  const auto reach = [&](double a) { return cutoffs.outer * 2 * a; };
  update_with(member, state, box, reach, [&](double a, double gap) -> PairResistance<double> {
    if (law == NoLubrication::name) return {};
    const PairResistance<double> k = wall_resistance(a, std::max(gap, cutoffs.inner * 2 * a));
    return law == NormalOnly::name ? PairResistance<double>{k.X, 0, 0, 0} : k;
  });
}

}  // namespace stresslet
