#include "stresslet/simulation/step.hpp"

#include "stresslet/exec/chunk_sum.hpp"
#include "stresslet/exec/timer.hpp"
#include "stresslet/lubrication/laws.hpp"
#include "stresslet/simulation/neighbours.hpp"
#include "stresslet/simulation/resolved/resolved_flow.hpp"
#include "stresslet/simulation/resolved/subgrid_films.hpp"
#include "stresslet/simulation/schemes/laws.hpp"

namespace stresslet {

namespace {

/// A part of a step.
struct Part {
  bool first, last;
  double share;
};

template <class Scheme>
void load_velocities(Member& member, Suspension& s) {
  const Range mine = member.share(s.state.size());
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    s.velocity.set(i, s.state.velocity(i), s.state.angular_velocity(i));
    s.velocity_now.set(i, Scheme::synchronous_velocity(s, i));
  }
  member.barrier();
}

void drift(Member& member, Suspension& s) {
  const double dt = s.time.substep();
  Box advanced = s.box;
  advanced.advance(dt);
  const Range mine = member.share(s.state.size());
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    Vec3<double> x = s.state.position(i);
    const Vec3<double> u = s.state.velocity(i);
    s.displacement_x[i] += dt * (u.x - s.box.mean_flow(x.y + 0.5 * dt * u.y));
    s.displacement_y[i] += dt * u.y;
    s.displacement_z[i] += dt * u.z;
    x += dt * u;
    advanced.wrap(x, s.state.ux[i]);
    s.state.set_position(i, x);
  }
  member.barrier();
  if (member.rank() == 0) {
    s.box = advanced;
    s.strain_since_build += s.box.mean_gradient() * dt;
  }
}

/// Everything from the separations to the new velocities; of the resolved fluid's step, what belongs to the first and
/// to the last part.
template <class Scheme>
void interact(Suspension& s, ThreadTeam& team, double contact_step, double velocity_step, Part part) {
  team.run([&](Member& member) {
    Timer timer;
    const auto charge = [&](double TimeSpent::*what) {
      if (member.rank() == 0) s.spent.*what += timer.seconds();
      timer.restart();
    };
    load_velocities<Scheme>(member, s);
    const ContactVelocities velocities{s.velocity, s.velocity_now};
    s.pairs.update(member, s.list, s.state, s.box);
    s.contacts.update(member, s.physics.contact, s.pairs, velocities, s.state, s.box.velocity_jump(), contact_step,
                      s.history);
    s.wall_contacts.update(member, s.physics.contact, s.state, velocities, s.box, contact_step);
    if (s.resolved) {
      if (member.rank() == 0)
        s.resolved->note_crossings(s.state, s.box, part.first, s.time.substep(), s.fluid_coupling);
      update_subgrid_films(member, s);
      charge(&TimeSpent::particles);
      if (part.first) s.resolved->prepare(member, s.state, s.box, s.fluid_coupling);
      charge(&TimeSpent::coupling);
    } else {
      s.lubrication.update(member, s.physics.lubrication_law, s.physics.cutoffs, s.pairs, s.box);
      s.walls.update(member, s.physics.lubrication_law, s.physics.cutoffs, s.state, s.box);
    }
    Scheme::advance_velocities(member, s, velocity_step);
    if (s.resolved) s.resolved->follow(member, s.state, part.first, part.share);
    charge(&TimeSpent::particles);
    if (!s.resolved || !part.last) return;
    s.resolved->sweep(member);
    charge(&TimeSpent::lattice);
  });
}

}  // namespace

void start(Suspension& s, ThreadTeam& team) {
  prepare_particle_arrays(s);
  rebuild_neighbours(s, team);
  if (s.resolved) s.resolved->fill(team, s.state, s.box);
  TimeSchemes::dispatch(s.time.scheme, [&](auto tag) {
    using Scheme = typename decltype(tag)::type;
    interact<Scheme>(s, team, 0.0, Scheme::first_step(s.time.step), {true, true, 1});
  });
}

void step(Suspension& s, ThreadTeam& team) {
  const int parts = s.time.substeps;
  const double dt = s.time.substep();
  for (int k = 0; k < parts; ++k) {
    const Timer timer;
    team.run([&](Member& member) { drift(member, s); });
    // What the fluid said of the particles in the first part, and their mean velocities, are kept by their places.
    if (!s.list.valid(largest_displacement(s), s.strain_since_build)) rebuild_neighbours(s, team, k == 0);
    s.spent.particles += timer.seconds();
    TimeSchemes::dispatch(s.time.scheme, [&](auto tag) {
      interact<typename decltype(tag)::type>(s, team, dt, dt, {k == 0, k == parts - 1, 1.0 / parts});
    });
  }
  ++s.steps;
  s.strain = double(s.steps) * s.time.step;
}

void resume(Suspension& s) {
  s.list.set_largest_distance(s.state);
  prepare_particle_arrays(s);
  prepare_pair_arrays(s);
}

TwistVector synchronous_velocities(const Suspension& s) {
  TwistVector synchronous;
  synchronous.resize(s.state.size());
  TimeSchemes::dispatch(s.time.scheme, [&](auto tag) {
    for (std::size_t i = 0; i < s.state.size(); ++i)
      synchronous.set(i, decltype(tag)::type::synchronous_velocity(s, i));
  });
  return synchronous;
}

Sample sample(const Suspension& s, ThreadTeam& team) {
  const TwistVector synchronous = synchronous_velocities(s);
  const StressModel model{s.physics.drag, s.physics.stresslet, sees_background(s.physics.lubrication_law)};
  Sample result =
      measure(team, {s.box, s.state, synchronous, s.pairs, s.contacts, s.wall_contacts, s.lubrication, s.walls}, model);
  if (s.resolved) {
    result.stress.stresslet = s.resolved->stresslet(s.state, s.box, s.fluid_coupling);
    const double background = s.box.mean_gradient() * s.box.mean_gradient();
    result.dissipation_drag = s.resolved->dissipation(team, s.state, s.box, s.fluid_coupling) - background -
                              result.stress.stresslet.xy * s.box.mean_gradient();
    s.resolved->add_to(result);
  }
  return result;
}

}  // namespace stresslet
