#include "validation/harness/resolved_flow.hpp"

#include <algorithm>
#include <cmath>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/coupling/laws.hpp"

namespace stresslet::validation {

namespace {

double drag_of_solid_cell(const ResolvedScheme& scheme) {
  double drag = 0;
  SolidWeights::dispatch(scheme.weight,
                         [&](auto w) { drag = typename decltype(w)::type(scheme.relaxation_time).drag(1.0); });
  return drag;
}

double exchange_factor(const ResolvedScheme& scheme) {
  double factor = 0;
  CouplingOperators::dispatch(scheme.coupling_operator, [&](auto o) { factor = decltype(o)::type::exchange; });
  return factor;
}

}  // namespace

FluidSetup resolved_box(const Cells& size, const ResolvedScheme& scheme) {
  FluidSetup setup;
  setup.grid.size = size;
  setup.collision = scheme.collision;
  setup.rates.relaxation_time = scheme.relaxation_time;
  setup.rates.magic_parameter = scheme.magic_parameter;
  return setup;
}

void add_moving_walls(FluidSetup& setup, double speed_lu, const std::string& law) {
  setup.grid.closure[1] = Closure::open;
  setup.faces[1] = {FaceSetup{law, {-speed_lu, 0, 0}, 1}, FaceSetup{law, {speed_lu, 0, 0}, 1}};
}

ResolvedFlow::ResolvedFlow(Trial& trial, const FluidSetup& setup, const ResolvedScheme& scheme,
                           std::vector<TestSphere> spheres, std::string label)
    : trial_(trial),
      scheme_(scheme),
      label_(std::move(label)),
      spheres_(std::move(spheres)),
      loads_(spheres_.size()),
      fluid_(setup, {scheme.coupling_operator, {scheme.fraction, scheme.weight, scheme.relaxation_time}}) {
  for (const TestSphere& s : spheres_) solids_.push_back(s.sphere);
}

void ResolvedFlow::settle() {
  std::vector<SphereInertia> inertia;
  for (const TestSphere& s : spheres_) {
    const double mass = s.own_mass_lu();
    inertia.push_back({mass,
                       0.4 * mass * s.sphere.radius * s.sphere.radius,
                       s.force_lu,
                       {},
                       s.motion == Motion::free,
                       s.motion != Motion::prescribed});
  }
  std::vector<SphereLink> links;
  for (const PointFriction& f : fluid_.friction()) links.push_back(link_of(f));
  if (films_) append_pair_forces(inertia, links);
  const auto sums = [&](std::size_t k) { return fluid_.exchange(k); };
  update_.settle(solids_, inertia, links, sums);
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    spheres_[k].sphere = solids_[k];
    loads_[k] = load_on_sphere(sums(k), solids_[k].velocity, solids_[k].angular_velocity);
  }
  for (const PointFriction& f : fluid_.friction()) {
    const ResolvedSphere &one = solids_[std::size_t(f.first)], &two = solids_[std::size_t(f.second)];
    const Vec3<double> on_first =
        f.force({one.velocity, one.angular_velocity}, {two.velocity, two.angular_velocity}, true);
    const auto add = [](HydrodynamicLoad& load, const Vec3<double>& force, const Vec3<double>& arm) {
      load.force += force;
      load.torque += cross(arm, force);
      load.stresslet += symmetric_product(force, arm);
    };
    add(loads_[std::size_t(f.first)], on_first, f.arm_first);
    add(loads_[std::size_t(f.second)], -on_first, f.arm_second);
  }
}

void ResolvedFlow::append_pair_forces(std::vector<SphereInertia>& inertia, std::vector<SphereLink>& links) const {
  for (std::size_t i = 0; i < solids_.size(); ++i)
    for (std::size_t j = i + 1; j < solids_.size(); ++j) {
      const auto film = subgrid_link(solids_, std::int32_t(i), std::int32_t(j), {}, scheme_.viscosity(), *films_);
      if (film) links.push_back(*film);
      const Vec3<double> apart = solids_[j].centre - solids_[i].centre;
      const double distance = norm(apart), overlap = solids_[i].radius + solids_[j].radius - distance;
      if (overlap <= 0) continue;
      const Vec3<double> on_second = (spring_ * overlap / distance) * apart;
      inertia[i].force -= on_second;
      inertia[j].force += on_second;
    }
}

void ResolvedFlow::step(Member& member) {
  if (frozen_ && member.rank() == 0) fluid_.lattice().shear_offset = fluid_.lattice().departure_offset = frozen_offset_;
  fluid_.prepare(member, solids_);
  if (member.rank() == 0) settle();
  member.barrier();
  fluid_.sweep(member, solids_);
  if (member.rank() == 0)
    for (std::size_t k = 0; k < spheres_.size(); ++k)
      if (spheres_[k].travels) solids_[k].centre = spheres_[k].sphere.centre += spheres_[k].sphere.velocity;
  member.barrier();
}

void ResolvedFlow::advance(int steps) {
  constexpr int together = 64;
  for (int done = 0; done < steps; done += together) {
    const int count = std::min(together, steps - done);
    trial_.team().run([&](Member& member) {
      for (int n = 0; n < count; ++n) step(member);
    });
    steps_ += count;
    if (trial_.progress().due()) trial_.progress().show(fmt::format("  {}: step {}", label_, steps_));
  }
}

void ResolvedFlow::advance_to_steady(double tolerance, int interval, int limit) {
  const auto readings = [&] {
    std::vector<double> all;
    for (std::size_t k = 0; k < spheres_.size(); ++k) {
      const double radius = spheres_[k].sphere.radius;
      const Vec3<double> force = radius * loads_[k].force, torque = loads_[k].torque;
      const SymTensor3<double>& s = loads_[k].stresslet;
      for (const double v :
           {force.x, force.y, force.z, torque.x, torque.y, torque.z, s.xy, s.xz, s.yz, s.xx - s.yy, s.yy - s.zz})
        all.push_back(v);
    }
    return all;
  };
  std::vector<double> before = readings();
  while (steps_ < limit) {
    advance(interval);
    const std::vector<double> now = readings();
    double change = 0, largest = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
      change = std::max(change, std::abs(now[k] - before[k]));
      largest = std::max(largest, std::abs(now[k]));
    }
    if (change <= tolerance * largest) return;
    before = now;
  }
  throw NumericalFailure({label_, fmt::format("the flow is not steady after {} steps", limit),
                          "the reference is a steady state", "report this as a bug"});
}

void ResolvedFlow::prepare() {
  trial_.team().run([&](Member& member) { fluid_.prepare(member, solids_); });
}

MomentParts ResolvedFlow::moment_parts(std::size_t k) {
  prepare();
  const double solid = drag_of_solid_cell(scheme_) * (1 - 1e-12), factor = exchange_factor(scheme_);
  MomentParts parts;
  for_each_covered_cell(fluid_.lattice(), fluid_.covered(), [&](const ReportedCell& c) {
    if (c.sphere != k) return;
    const Vec3<double> us = rigid_velocity(solids_[k].velocity, solids_[k].angular_velocity, c.arm);
    const Vec3<double> force = -factor * c.share * c.density * (us - c.velocity);
    const double above = 0.5 * force.x * c.arm.y, beside = 0.5 * force.y * c.arm.x;
    (c.drag >= solid ? parts.volume : parts.surface) += above + beside;
    parts.quarter[c.arm.y > 0 ? 0 : 1] += above;
    parts.quarter[c.arm.x > 0 ? 2 : 3] += beside;
  });
  return parts;
}

CellPopulations<D3Q19, double> ResolvedFlow::populations(const Cells& cell) {
  const auto& lattice = fluid_.lattice();
  for (const auto& block : lattice.blocks) {
    const BlockLayout& layout = block.populations.layout();
    const Cells local{cell[0] - block.origin[0], cell[1] - block.origin[1], cell[2] - block.origin[2]};
    if (local[0] >= 0 && local[0] < layout.size()[0] && local[1] >= 0 && local[1] < layout.size()[1] && local[2] >= 0 &&
        local[2] < layout.size()[2])
      return incoming(block.populations, lattice.arrangement, layout.index(local[0], local[1], local[2]));
  }
  return {};
}

Vec3<double> ResolvedFlow::mean_velocity() {
  const Cells& n = fluid_.lattice().grid.size;
  return (1 / (double(n[0]) * n[1] * n[2])) * fluid_.totals(trial_.team()).momentum;
}

Vec3<double> ResolvedFlow::momentum() {
  Vec3<double> sum = fluid_.totals(trial_.team()).momentum;
  for (const TestSphere& s : spheres_) sum += s.own_mass_lu() * s.sphere.velocity;
  return sum;
}

Vec3<double> ResolvedFlow::velocity(const Cells& cell) {
  prepare();
  const Moments<double> m = moments_of(populations(cell));
  Vec3<double> u = (m.momentum + 0.5 * fluid_.lattice().input.force_density) / m.density(), change{};
  for_each_covered_cell(fluid_.lattice(), fluid_.covered(), [&](const ReportedCell& c) {
    if (c.cell != cell) return;
    const ResolvedSphere& s = solids_[c.sphere];
    change +=
        0.5 * exchange_factor(scheme_) * c.share * (rigid_velocity(s.velocity, s.angular_velocity, c.arm) - c.velocity);
  });
  return u + change;
}

double ResolvedFlow::plane_stress(int y) {
  prepare();
  const Cells& n = fluid_.lattice().grid.size;
  double upwards = 0;
  for (int z = 0; z < n[2]; ++z)
    for (int x = 0; x < n[0]; ++x) {
      const auto above = populations({x, y + 1, z}), below = populations({x, y, z});
      unroll<D3Q19::pairs>([&](auto k) {
        constexpr int i = first_of_pair(k);
        constexpr auto c = D3Q19::velocity[i];
        if constexpr (c[1] != 0) {
          // Population i of the pair moves along c, its partner against it.
          const double along = 0.5 * (above.pair[k].even + above.pair[k].odd);
          const double against = 0.5 * (above.pair[k].even - above.pair[k].odd);
          const double along_below = 0.5 * (below.pair[k].even + below.pair[k].odd);
          const double against_below = 0.5 * (below.pair[k].even - below.pair[k].odd);
          upwards += c[1] > 0 ? c[0] * along + c[0] * against_below : -c[0] * against - c[0] * along_below;
        }
      });
    }
  return -upwards / (double(n[0]) * n[2]);
}

}  // namespace stresslet::validation
