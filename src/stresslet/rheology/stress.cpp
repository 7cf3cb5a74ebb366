#include "stresslet/rheology/stress.hpp"

#include <algorithm>

#include "stresslet/exec/chunk_sum.hpp"
#include "stresslet/lubrication/single_sphere.hpp"

namespace stresslet {

namespace {

struct Addable : Sample {
  Addable& operator+=(const Addable& b) {
    stress.contact += b.stress.contact;
    stress.lubrication_normal += b.stress.lubrication_normal;
    stress.lubrication_tangential += b.stress.lubrication_tangential;
    stress.lubrication_rotational += b.stress.lubrication_rotational;
    stress.lubrication_strain += b.stress.lubrication_strain;
    stress.stresslet += b.stress.stresslet;
    stress.reynolds += b.stress.reynolds;
    stress.acceleration += b.stress.acceleration;
    dissipation_lubrication += b.dissipation_lubrication, dissipation_sliding += b.dissipation_sliding;
    dissipation_dashpot += b.dissipation_dashpot, dissipation_drag += b.dissipation_drag;
    elastic_energy += b.elastic_energy, kinetic_energy += b.kinetic_energy;
    contacts += b.contacts, largest_overlap = std::max(largest_overlap, b.largest_overlap);
    momentum += b.momentum;
    return *this;
  }
};

Vec3<double> mean_rotation(const Box& box) { return {0, 0, -0.5 * box.mean_gradient()}; }

SymTensor3<double> mean_strain_rate(const Box& box) { return {0, 0, 0, 0.5 * box.mean_gradient(), 0, 0}; }

void add_contact(const ContactResult& c, const Vec3<double>& r, double relative_overlap, Addable& sum) {
  sum.stress.contact += symmetric_product(r, c.force);
  sum.dissipation_sliding += c.sliding_power;
  sum.dissipation_dashpot += c.dashpot_power;
  sum.elastic_energy += c.elastic_energy;
  sum.contacts += 1;
  sum.largest_overlap = std::max(sum.largest_overlap, relative_overlap);
}

void add_pair(const Instant& now, std::size_t p, const StressModel& model, Addable& sum) {
  const ActivePairs& pairs = now.pairs;
  const Vec3<double> e = pairs.normal(p), r = pairs.distance[p] * e;
  if (pairs.gap[p] < 0)
    add_contact(now.contacts[p], r, -pairs.gap[p] / (2 * std::min(pairs.radius_i[p], pairs.radius_j[p])), sum);

  const PairResistance<double> k = now.lubrication.resistance(p);
  const Twist<double> t1 = now.velocity.get(std::size_t(pairs.i[p])), t2 = now.velocity.get(std::size_t(pairs.j[p]));
  PairMotion<double> motion{t2.linear - t1.linear, t1.angular, t2.angular};
  Vec3<double> u = motion.u;
  u.x -= pairs.images_up[p] * now.box.velocity_jump();
  motion.u.x += now.lubrication.background_velocity(p);
  const auto m = lubricated_motion(e, now.lubrication.arm(p), motion);
  const auto w = pair_wrench(e, now.lubrication.arm(p), k, motion);

  Vec3<double> normal = k.X * m.normal * e, tangential = k.Y * m.sliding;
  if (model.lubrication_sees_background) {
    const Vec3<double> stretch = now.lubrication.arm(p) * (mean_strain_rate(now.box) * e);
    const double stretch_n = dot(stretch, e);
    const Vec3<double> strain_n = k.X * stretch_n * e, strain_t = k.Y * (stretch - stretch_n * e);
    sum.stress.lubrication_strain += symmetric_product(r, strain_n + strain_t);
    normal -= strain_n, tangential -= strain_t;
  }
  sum.stress.lubrication_normal += symmetric_product(r, normal);
  sum.stress.lubrication_tangential += symmetric_product(r, tangential);
  sum.stress.lubrication_rotational += symmetric_product(r, k.B * m.counter_spin);

  const Vec3<double> torque1 = w.half_sum - w.half_difference, torque2 = w.half_sum + w.half_difference;
  sum.dissipation_lubrication += dot(w.force, u) - dot(torque1, motion.w1) - dot(torque2, motion.w2) +
                                 dot(mean_rotation(now.box), torque1 + torque2 - cross(r, w.force));
}

/// First moment, symmetric part, of what a wall along r = (a + gap) e does to a sphere by a force along itself with a
/// torque. Of the force, T x e / a acts where the sphere faces the wall; the rest is pressure, which has no torque but
/// twice the symmetric moment. Of two spheres the two parts balance, and sym(r F) is all.
Stress wall_moment(const Vec3<double>& r, const Vec3<double>& e, const WallWrench<double>& w) {
  return 2.0 * symmetric_product(r, w.force) - symmetric_product(e, cross(w.torque, e));
}

/// The wall moves with the mean flow at its place.
void add_wall(const Instant& now, std::size_t i, const Twist<double>& t, Addable& sum) {
  const auto& contact = now.wall_contacts[i];
  if (contact.normal_y != 0)
    add_contact(contact.result, {0, contact.normal_y * contact.arm, 0}, contact.overlap / (2 * now.state.radius[i]),
                sum);
  const WallFilm& film = now.walls[i];
  if (film.normal_y == 0) return;
  const Vec3<double> e = film.normal(), r = (now.state.radius[i] + film.gap) * e;
  const Vec3<double> u = Vec3<double>{film.wall_velocity, 0, 0} - t.linear;
  sum.stress.lubrication_normal += symmetric_product(r, film.k.X * dot(u, e) * e);
  sum.stress.lubrication_tangential += wall_moment(r, e, wall_wrench(e, film.k, tangential_part(u, e), {}));
  sum.stress.lubrication_rotational += wall_moment(r, e, wall_wrench(e, film.k, {}, t.angular));
  const auto w = wall_wrench(e, film.k, u, t.angular);
  sum.dissipation_lubrication += dot(w.force, u) - dot(w.torque, t.angular);
}

void add_particle(const Instant& now, std::size_t i, const StressModel& model, Addable& sum) {
  const ParticleState& s = now.state;
  const double a = s.radius[i], m = s.own_mass(i);
  const Twist<double> t = now.velocity.get(i);
  const Vec3<double> c = t.linear - Vec3<double>{now.box.mean_flow(s.y[i]), 0, 0};
  const Vec3<double> spin = t.angular - mean_rotation(now.box);
  sum.momentum += m * c;
  sum.kinetic_energy += 0.5 * (m * dot(c, c) + s.own_inertia(i) * dot(spin, spin));
  sum.stress.reynolds -= m * square(c);
  sum.stress.acceleration -= (0.2 * m * a * a) * (square(t.angular) - dot(t.angular, t.angular) * identity3<double>());
  if (model.stresslet) sum.stress.stresslet += stresslet_coefficient(a) * mean_strain_rate(now.box);
  if (model.drag) sum.dissipation_drag += translational_drag(a) * dot(c, c) + rotational_drag(a) * dot(spin, spin);
  if (now.walls.present()) add_wall(now, i, t, sum);
}

}  // namespace

Sample measure(ThreadTeam& team, const Instant& now, const StressModel& model) {
  ChunkSum<Addable> pair_sum, particle_sum;
  pair_sum.resize(now.pairs.size());
  particle_sum.resize(now.state.size());
  Addable total;
  team.run([&](Member& member) {
    Addable sum = pair_sum(member, now.pairs.size(), [&](std::size_t begin, std::size_t end) {
      Addable part;
      for (std::size_t p = begin; p < end; ++p) add_pair(now, p, model, part);
      return part;
    });
    sum += particle_sum(member, now.state.size(), [&](std::size_t begin, std::size_t end) {
      Addable part;
      for (std::size_t i = begin; i < end; ++i) add_particle(now, i, model, part);
      return part;
    });
    if (member.rank() == 0) total = sum;
  });

  const double per_volume = 1 / now.box.volume();
  Sample result = total;
  StressParts::for_each(result.stress, [&](const char*, Stress& part) { part = per_volume * part; });
  for (double* v : {&result.dissipation_lubrication, &result.dissipation_sliding, &result.dissipation_dashpot,
                    &result.dissipation_drag, &result.elastic_energy, &result.kinetic_energy})
    *v *= per_volume;
  return result;
}

}  // namespace stresslet
