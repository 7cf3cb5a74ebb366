#pragma once
/// Suspensions of a few given spheres, and packings of a few dozen, for tests.
#include <stdexcept>
#include <string>
#include <vector>

#include "stresslet/particles/packing/generator.hpp"
#include "stresslet/particles/sizes/laws.hpp"
#include "stresslet/simulation/step.hpp"
#include "stresslet/simulation/suspension.hpp"

namespace stresslet::testing {

struct Sphere {
  Vec3<double> position;
  double radius = 0.5;
  Vec3<double> velocity{}, angular_velocity{};
};

/// Contacts alone: no drag, no lubrication, no stresslet.
inline Physics dry(const ContactParameters& contact) {
  Physics p;
  p.contact = contact;
  p.lubrication_law = "none";
  p.drag = p.stresslet = false;
  return p;
}

inline TimeControl time_control(const std::string& scheme, double step, double solver_tolerance = 1e-3) {
  TimeControl t;
  t.scheme = scheme, t.step = step, t.solver_tolerance = solver_tolerance;
  return t;
}

inline InteractionRange range_of(const Physics& physics) {
  return {physics.lubrication_law == "none" ? 0.0 : physics.cutoffs.outer};
}

/// Spheres of one density, ids in the order given; call `start` next. `skin` is that of the Verlet list, which bounds
/// the box from below: twice (largest diameter + range + skin).
inline Suspension small_system(const Box& box, const std::vector<Sphere>& spheres, const Physics& physics,
                               const TimeControl& time, double density, double skin = 0.15) {
  Suspension s;
  s.physics = physics, s.time = time, s.box = box;
  s.list = VerletList(range_of(physics), skin);
  s.state.resize(spheres.size());
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    s.state.set_position(i, spheres[i].position);
    s.state.set_velocity(i, spheres[i].velocity);
    s.state.set_angular_velocity(i, spheres[i].angular_velocity);
    s.state.radius[i] = spheres[i].radius, s.state.density[i] = density;
    s.state.species[i] = 0, s.state.id[i] = std::int32_t(i);
  }
  return s;
}

/// 1 : 1.4 mixture of equal volumes in a sheared cube, carried by the mean flow.
inline Suspension packed_system(std::size_t count, double solid_fraction, const Physics& physics,
                                const TimeControl& time, double density = 0.1, std::uint64_t seed = 1) {
  PackingRequest request;
  request.solid_fraction = solid_fraction, request.seed = seed, request.density = density;
  Packing packing = generate_packing(Discrete::sizes({{1, 1.4}, {}, {0.5, 0.5}}, count), request);
  Suspension s;
  s.physics = physics, s.time = time, s.box = packing.box;
  s.list = VerletList(range_of(physics), 0.15);
  s.state = std::move(packing.state);
  return s;
}

/// The same particles and contact history at time zero of another scheme or step, started.
inline Suspension continued(const Suspension& before, const TimeControl& time, ThreadTeam& team) {
  Suspension s = before;
  s.time = time;
  s.steps = 0, s.strain = 0;
  s.change.resize(s.state.size());
  start(s, team);
  return s;
}

/// Index of the particle with this permanent name; spatial sorting moves particles.
inline std::size_t index_of(const Suspension& s, std::int32_t id) {
  for (std::size_t i = 0; i < s.state.size(); ++i)
    if (s.state.id[i] == id) return i;
  throw std::out_of_range("no particle of this id");
}

inline void advance(Suspension& s, ThreadTeam& team, std::int64_t steps) {
  for (std::int64_t n = 0; n < steps; ++n) step(s, team);
}

}  // namespace stresslet::testing
