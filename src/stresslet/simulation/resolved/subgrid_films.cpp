#include "stresslet/simulation/resolved/subgrid_films.hpp"

#include "stresslet/coupling/laws.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"

namespace stresslet {

void update_subgrid_films(Member& member, Suspension& s) {
  const std::optional<SubgridCorrection>& correction = s.resolved->setup().correction;
  if (!correction) {
    s.lubrication.update_with(member, s.pairs, s.box,
                              [](const Pack&, const Pack&, const Pack&) { return PairResistance<Pack>{}; });
    return s.walls.update_with(
        member, s.state, s.box, [](double) { return 0.0; }, [](double, double) { return PairResistance<double>{}; });
  }
  const double cell = s.resolved->setup().cell;
  const auto scaled = [&](const SubgridLengths& l) {
    return SubgridLengths{cell * l.normal, cell * l.sliding, cell * l.spin};
  };
  const SubgridLengths lengths = scaled(correction->lengths), at_walls = scaled(correction->lengths_at_walls());
  const SubgridRange range{s.physics.cutoffs.inner, cell * correction->range.outer};
  SubgridLaws::dispatch(correction->law, [&](auto law) {
    using Law = typename decltype(law)::type;
    s.lubrication.update_with(member, s.pairs, s.box, [&](const Pack& a1, const Pack& a2, const Pack& gap) {
      return subgrid_resistance<Law>(a1, a2, gap, lengths, range);
    });
    s.walls.update_with(
        member, s.state, s.box, [&](double) { return range.outer; },
        [&](double a, double gap) { return subgrid_wall_resistance<Law>(a, gap, at_walls, range); });
  });
}

}  // namespace stresslet
