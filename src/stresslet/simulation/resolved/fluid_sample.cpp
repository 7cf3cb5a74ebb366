#include "stresslet/simulation/resolved/fluid_sample.hpp"

#include "stresslet/simulation/resolved/virtual_films.hpp"
#include "stresslet/simulation/step.hpp"
#include "stresslet/simulation/stored.hpp"

namespace stresslet {

namespace {

/// x of the force on the first of a pair.
double pair_force(const Suspension& s, std::size_t p) {
  const Vec3<double> e = s.pairs.normal(p);
  const Twist<double> t1 = s.velocity.get(std::size_t(s.pairs.i[p])), t2 = s.velocity.get(std::size_t(s.pairs.j[p]));
  PairMotion<double> motion{t2.linear - t1.linear, t1.angular, t2.angular};
  motion.u.x += s.lubrication.background_velocity(p);
  const double film = pair_wrench(e, s.lubrication.arm(p), s.lubrication.resistance(p), motion).force.x;
  return s.pairs.gap[p] < 0 ? film + s.contacts[p].force.x : film;
}

/// x of the forces of the walls on the spheres, of the upper less that of the lower one.
double wall_forces(const Suspension& s) {
  double sum = 0;
  for (std::size_t i = 0; i < s.state.size(); ++i) {
    const WallFilm& film = s.walls[i];
    Twist<double> wrench;
    s.walls.add_to<true>(i, s.velocity.get(i), wrench);
    sum += film.normal_y * wrench.linear.x;
    const auto& contact = s.wall_contacts[i];
    if (contact.normal_y != 0) sum += contact.normal_y * contact.result.force.x;
  }
  return sum;
}

}  // namespace

double stress_through_plane(const Suspension& s, ThreadTeam& team) {
  double force = s.resolved->force_across_plane(team, s.box, s.fluid_coupling, s.state);
  for (std::size_t p = 0; p < s.pairs.size(); ++p)
    if (s.pairs.images_up[p] != 0) force -= s.pairs.images_up[p] * pair_force(s, p);  // -1: j above i
  if (s.walls.present()) force += 0.5 * wall_forces(s);
  const CarriedAcross& carried = s.resolved->carried();
  if (carried.steps > 0) force -= carried.momentum / (double(carried.steps) * s.time.step);
  return force / (s.box.length.x * s.box.length.z);
}

FluidSample sample_fluid(Suspension& s, ThreadTeam& team) {
  const FluidEnergy& look = s.resolved->last_look();
  FluidSample found{0,
                    0,
                    look.lowest_density,
                    look.highest_density,
                    s.resolved->kinetic_stresslet(s.box).xy,
                    virtual_film_stress(s, synchronous_velocities(s), team)};
  if (s.resolved->setup().is_sheared()) {
    found.viscosity_through_plane = stress_through_plane(s, team);
    found.stored_momentum = s.resolved->stored_momentum(s.state, s.box);
  }
  s.resolved->set_carried({});
  return found;
}

void add_carried(Checkpoint& checkpoint, const CarriedAcross& carried) {
  checkpoint.scalars["carried_momentum"] = carried.momentum;
  checkpoint.scalars["carried_steps"] = carried.steps;
}

CarriedAcross carried_across(const Checkpoint& c) {
  return {stored<double>(c.scalars, "carried_momentum"), stored<std::int64_t>(c.scalars, "carried_steps")};
}

}  // namespace stresslet
