#include "stresslet/simulation/resolved/virtual_films.hpp"

#include "stresslet/lubrication/laws.hpp"

namespace stresslet {

StressParts virtual_film_stress(const Suspension& s, const TwistVector& velocity, ThreadTeam& team) {
  const StressModel model{false, false, sees_background(s.physics.lubrication_law)};
  PairLubrication lubrication;
  lubrication.prepare(s.list.size());
  WallFilms walls;
  walls.prepare(s.state.size(), s.box);
  team.run([&](Member& member) {
    lubrication.update(member, s.physics.lubrication_law, s.physics.cutoffs, s.pairs, s.box);
    walls.update(member, s.physics.lubrication_law, s.physics.cutoffs, s.state, s.box);
  });
  const StressParts all =
      measure(team, {s.box, s.state, velocity, s.pairs, s.contacts, s.wall_contacts, lubrication, walls}, model).stress;
  StressParts found;
  found.lubrication_normal = all.lubrication_normal;
  found.lubrication_tangential = all.lubrication_tangential;
  found.lubrication_rotational = all.lubrication_rotational;
  found.lubrication_strain = all.lubrication_strain;
  return found;
}

}  // namespace stresslet
