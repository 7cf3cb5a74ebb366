#include "prepared_suspension.hpp"

#include <map>

#include "stresslet/particles/packing/generator.hpp"
#include "stresslet/particles/sizes/discrete.hpp"
#include "stresslet/simulation/step.hpp"
#include "stresslet/simulation/time_step.hpp"

namespace stresslet::benchmarks {

namespace {

constexpr double stokes_number = 0.1;
constexpr double skin = 0.15;

double default_step(const Suspension& s, const std::string& scheme) {
  return step_bounds(s.physics, scheme, s.state.radius, stokes_number).chosen;
}

Suspension make(std::size_t particles) {
  Packing packing = generate_packing(Discrete::sizes({{1.0, 1.4}, {}, {0.5, 0.5}}, particles),
                                     {.solid_fraction = 0.5, .density = stokes_number, .where = {}});
  Suspension s;
  s.physics.contact.stiffness = 2.5e5;
  s.box = packing.box;
  s.state = std::move(packing.state);
  s.list = VerletList({s.physics.cutoffs.outer}, skin);
  s.time.step = default_step(s, s.time.scheme);
  ThreadTeam team(1);
  start(s, team);
  const double strain = particles <= 20000 ? 0.2 : 0.005;
  while (s.strain < strain) step(s, team);
  return s;
}

}  // namespace

const Suspension& prepared(std::size_t particles) {
  static std::map<std::size_t, Suspension> kept;
  const auto found = kept.find(particles);
  return found != kept.end() ? found->second : kept.emplace(particles, make(particles)).first->second;
}

Suspension prepared_for(std::size_t particles, const std::string& scheme, ThreadTeam& team) {
  Suspension s = prepared(particles);
  if (s.time.scheme == scheme) return s;
  s.time.scheme = scheme;
  s.time.step = default_step(s, scheme);
  start(s, team);
  return s;
}

}  // namespace stresslet::benchmarks
