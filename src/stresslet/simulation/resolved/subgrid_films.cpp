#include "stresslet/simulation/resolved/subgrid_films.hpp"

#include "stresslet/coupling/laws.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"

namespace stresslet {

void update_subgrid_films(Member& member, Suspension& s) {
  const std::optional<SubgridCorrection>& correction = s.resolved->setup().correction;
  if (!correction)
    return s.lubrication.update_with(member, s.pairs, s.box,
                                     [](double, double, double) { return PairResistance<double>{}; });
  const double cell = s.resolved->setup().cell;
  const SubgridLengths& l = correction->lengths;
  const SubgridLengths lengths{cell * l.normal, cell * l.sliding, cell * l.spin};
  const SubgridRange range{s.physics.cutoffs.inner, cell * correction->range.outer};
  SubgridLaws::dispatch(correction->law, [&](auto law) {
    s.lubrication.update_with(member, s.pairs, s.box, [&](double a1, double a2, double gap) {
      return subgrid_resistance<typename decltype(law)::type>(a1, a2, gap, lengths, range);
    });
  });
}

}  // namespace stresslet
