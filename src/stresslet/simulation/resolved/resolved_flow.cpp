#include "stresslet/simulation/resolved/resolved_flow.hpp"

#include <cmath>
#include <utility>

#include "stresslet/lattice/boundary/walls.hpp"
#include "stresslet/simulation/resolved/starting_flow.hpp"

namespace stresslet {

namespace {

FluidSetup fluid_setup(const ResolvedSetup& s) {
  FluidSetup setup;
  setup.grid.size = s.cells;
  setup.collision = s.collision;
  setup.rates = s.rates;
  setup.single_precision = s.single_precision;
  const double jump = s.velocity_difference_lu();
  if (s.box == BoxKind::lees_edwards) {
    setup.grid.closure[1] = Closure::sheared;
    setup.shear_velocity_lu = jump;
  } else if (s.box == BoxKind::walls) {
    setup.grid.closure[1] = Closure::open;
    const std::string law(HalfWay::name);
    setup.faces[1] = {FaceSetup{law, {-0.5 * jump, 0, 0}}, FaceSetup{law, {0.5 * jump, 0, 0}}};
  }
  return setup;
}

}  // namespace

double ResolvedSetup::mach() const { return 0.5 * velocity_difference_lu() / std::sqrt(speed_of_sound_squared); }

ResolvedFlow::ResolvedFlow(const ResolvedSetup& setup)
    : setup_(setup),
      step_(setup.step()),
      mass_unit_(setup.reynolds * setup.cell * setup.cell * setup.cell),
      fluid_(ResolvedFluid::make(fluid_setup(setup), setup.coupling)) {}

void ResolvedFlow::fill(ThreadTeam& team, const ParticleState& state, const Box& box) {
  std::vector<ResolvedSphere> spheres(state.size());
  for (std::size_t i = 0; i < spheres.size(); ++i)
    spheres[i] = {centre_lu(state, i), state.radius[i] / setup_.cell, step_ / setup_.cell * state.velocity(i),
                  step_ * state.angular_velocity(i)};
  fluid_->initialise(team, StartingFlow(fluid_setup(setup_).grid, box.offset / setup_.cell,
                                        setup_.velocity_difference_lu(), std::move(spheres)));
}

Vec3<double> ResolvedFlow::centre_lu(const ParticleState& state, std::size_t i) const {
  return state.position(i) / setup_.cell - Vec3<double>{0.5, 0.5, 0.5};
}

void ResolvedFlow::prepare(Member& member, const ParticleState& state, const Box& box, FluidCoupling& coupling) {
  const std::size_t n = state.size();
  if (member.rank() == 0) {
    spheres_.resize(n);
    frame_.assign(n, 0.0);
    coupling.resistance.resize(n);
    coupling.push.resize(n);
    if (setup_.box == BoxKind::lees_edwards) fluid_->follow_shear(box.offset / setup_.cell);
  }
  member.barrier();
  const Range mine = member.share(n);
  for (std::size_t i = mine.begin; i < mine.end; ++i)
    spheres_[i] = {centre_lu(state, i), state.radius[i] / setup_.cell};
  member.barrier();
  fluid_->prepare(member, spheres_);

  const double rate = mass_unit_ / step_, length = setup_.cell, velocity = length / step_;
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    const ExchangeSums& s = fluid_->exchange(i);
    coupling.resistance[i] = {rate * s.mass, rate * length * s.first, rate * length * length * s.rotational()};
    coupling.push[i] = {rate * velocity * s.momentum, rate * velocity * length * s.angular_momentum()};
  }
  if (member.rank() == 0) {
    std::vector<PointFriction> friction = fluid_->friction();
    for (PointFriction& f : friction) {
      f.coefficient *= rate;
      f.arm_first = length * f.arm_first, f.arm_second = length * f.arm_second;
      f.jump = velocity * f.jump;
    }
    coupling.set_friction(std::move(friction), n);
  }
  member.barrier();
}

void ResolvedFlow::note_crossings(const ParticleState& state, const Box& box, bool first, double step,
                                  FluidCoupling& coupling) {
  carried_.steps += first;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double boxes_up = std::floor((state.y[i] - step * state.uy[i]) / box.length.y);
    if (boxes_up == 0) continue;
    const double gain = boxes_up * box.velocity_jump();
    carried_.momentum -= boxes_up * state.own_mass(i) * (state.ux[i] - 0.5 * gain);
    if (first) continue;
    frame_[i] += gain;
    coupling.change_frame(i, {gain, 0, 0});
  }
}

void ResolvedFlow::follow(Member& member, const ParticleState& state, bool first, double share) {
  const Range mine = member.share(state.size());
  for (std::size_t i = mine.begin; i < mine.end; ++i) {
    ResolvedSphere& sphere = spheres_[i];
    if (first) sphere.velocity = sphere.angular_velocity = {};
    sphere.velocity += (share * step_ / setup_.cell) * (state.velocity(i) - Vec3<double>{frame_[i], 0, 0});
    sphere.angular_velocity += share * step_ * state.angular_velocity(i);
  }
  member.barrier();
}

Stress ResolvedFlow::stresslet(const ParticleState& state, const Box& box, const FluidCoupling& coupling) const {
  Stress sum{};
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    sum += load_on_sphere(fluid_->exchange(i), spheres_[i].velocity, spheres_[i].angular_velocity).complete_stresslet();
  sum = energy_unit() * sum;
  const auto twist = [&](std::int32_t i) {
    return Twist<double>{state.velocity(std::size_t(i)), state.angular_velocity(std::size_t(i))};
  };
  for (const PointFriction& f : coupling.friction())
    sum += symmetric_product(f.arm_first - f.arm_second, f.force(twist(f.first), twist(f.second), true));
  return (1 / box.volume()) * sum;
}

Stress ResolvedFlow::kinetic_stresslet(const Box& box) const {
  Stress sum{};
  for (std::size_t i = 0; i < spheres_.size(); ++i)
    sum += load_on_sphere(fluid_->exchange(i), spheres_[i].velocity, spheres_[i].angular_velocity).kinetic;
  return (energy_unit() / box.volume()) * sum;
}

double ResolvedFlow::dissipation(ThreadTeam& team, const ParticleState& state, const Box& box,
                                 const FluidCoupling& coupling) {
  std::vector<ResolvedSphere> next = spheres_;
  for (std::size_t i = 0; i < next.size(); ++i) next[i].centre += next[i].velocity;
  look_ = fluid_->energy(team, next, planes_);
  double rubbed = 0;
  for (const PointFriction& f : coupling.friction()) {
    const std::size_t i = std::size_t(f.first), j = std::size_t(f.second);
    const Vec3<double> force =
        f.force({state.velocity(i), state.angular_velocity(i)}, {state.velocity(j), state.angular_velocity(j)}, true);
    rubbed += dot(force, force) / f.coefficient;
  }
  return (energy_unit() / step_ * (look_.collisions + look_.slip) + rubbed) / box.volume();
}

void ResolvedFlow::add_to(Sample& sample) const {
  const double volume = setup_.cell_count() * setup_.cell * setup_.cell * setup_.cell;
  const double per_volume = energy_unit() / volume;
  sample.stress.reynolds -= per_volume * look_.reynolds;
  sample.kinetic_energy += per_volume * look_.kinetic();
}

double ResolvedFlow::force_across_plane(ThreadTeam& team, const Box& box, const FluidCoupling& coupling,
                                        const ParticleState& state) {
  double force = -mass_unit_ * setup_.cell / (step_ * step_) * fluid_->momentum_across(team, spheres_);
  for (const PointFriction& f : coupling.friction()) {
    if (f.jump.x == 0) continue;
    const std::size_t i = std::size_t(f.first), j = std::size_t(f.second);
    const Vec3<double> on_first =
        f.force({state.velocity(i), state.angular_velocity(i)}, {state.velocity(j), state.angular_velocity(j)}, true);
    force += std::round(f.jump.x / box.velocity_jump()) * on_first.x;
  }
  return force;
}

double ResolvedFlow::stored_momentum(const ParticleState& state, const Box& box) const {
  double sum = mass_unit_ * setup_.cell * setup_.cell / step_ * look_.stored_momentum;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const double height = state.y[i] - 0.5 * box.length.y;
    // A sphere that moves across the mean flow changes its momentum against that without a force: half a square.
    sum += state.own_mass(i) * height * (state.ux[i] - 0.5 * box.mean_flow(state.y[i]));
  }
  return sum / box.volume();
}

void ResolvedFlow::restore(ThreadTeam& team, const std::vector<double>& populations, std::int64_t steps,
                           double offset) {
  fluid_->restore(team, populations, steps);
  if (setup_.box == BoxKind::lees_edwards) fluid_->set_shear_offset(offset / setup_.cell);
}

}  // namespace stresslet
