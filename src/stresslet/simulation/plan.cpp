#include "stresslet/simulation/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "stresslet/base/constants.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/particles/packing/generator.hpp"
#include "stresslet/particles/sizes/laws.hpp"
#include "stresslet/simulation/neighbours.hpp"
#include "stresslet/simulation/resolved/resolved_plan.hpp"
#include "stresslet/simulation/start_file.hpp"

namespace stresslet {

namespace {

constexpr double skin = 0.15;  // in d1: a list lasts for some 200 steps

/// Viscosity used only to estimate forces and times: (1 - phi/phi_max)^-1.7 with the frictional or frictionless
/// phi_max, bounded near jamming.
double rough_viscosity(double solid_fraction, double friction) {
  const double reach = friction > 0.1 ? 0.576 : 0.65;
  return std::pow(std::max(1 - solid_fraction / reach, 0.02), -1.7);
}

std::vector<SizeClassed> make_sizes(const Case& c) {
  const SizesInput& s = *c.suspension.sizes;
  const std::size_t count = std::size_t(*c.suspension.count);
  switch (s.law) {
    case SizeLaw::monodisperse:
      return Monodisperse::sizes({1.0}, count);
    case SizeLaw::discrete:
      return Discrete::sizes({*s.diameters, s.number_shares.value_or(std::vector<double>{}),
                              s.volume_shares.value_or(std::vector<double>{})},
                             count);
    case SizeLaw::lognormal:
      return Lognormal::sizes({*s.median_diameter, *s.sigma, *s.smallest, *s.largest}, count);
    case SizeLaw::table:
      return Table::sizes(read_size_table(*s.file, *s.shares), count);
  }
  throw std::logic_error("size law without sizes");
}

/// Largest overlaps seen are about 35 viscosity gdot d1^2 eta_r / kn (docs/theory.md, "Stiffness").
double stiffness_for_overlap(const Case& c, double solid_fraction) {
  constexpr double force_scale = 35;
  const double force = force_scale * rough_viscosity(solid_fraction, c.contact.friction);
  const double overlap = *c.contact.largest_overlap;
  return c.contact.normal == "hertz" ? force / (overlap * std::sqrt(overlap * 0.25)) : force / overlap;
}

Physics make_physics(const Case& c, double solid_fraction) {
  Physics p;
  const ModelSwitches switches = c.switches();
  p.lubrication_law = switches.lubrication;
  p.drag = switches.drag;
  p.stresslet = switches.stresslet;
  p.cutoffs = {c.lubrication.inner_cutoff, c.lubrication.outer_cutoff};
  p.contact.normal_law = c.contact.normal;
  p.contact.stiffness = c.contact_stiffness() ? *c.contact_stiffness() : stiffness_for_overlap(c, solid_fraction);
  p.contact.tangential_ratio = c.contact.tangential_ratio;
  p.contact.friction = c.contact.friction;
  p.contact.damping_ratio = c.contact.restitution < 1 ? damping_ratio(c.contact.restitution) : 0.0;
  p.contact.coulomb_limit = c.contact.coulomb_limit;
  return p;
}

/// The default step, shortened so that a whole number of steps falls between two samples.
double settled_step(const Case& c, const StepBounds& bounds) {
  if (!c.time.step) return *c.output.sample_every / std::ceil(*c.output.sample_every / bounds.chosen - 1e-9);
  if (*c.time.step <= bounds.largest) return *c.time.step;
  throw InputError(
      {c.where("time.step"),
       fmt::format("time.step = {:.4g} is above the largest step {:.4g} of the {} scheme", *c.time.step, bounds.largest,
                   c.time.scheme),
       fmt::format("it is limited by {}; a longer step does not blow up but loses contacts silently", bounds.binding),
       fmt::format("leave time.step out ({:.4g} is then used), or choose another time.scheme", bounds.chosen)});
}

void check_walls(const Case& c, const Plan& plan) {
  if (plan.box.kind != BoxKind::walls || plan.physics.cutoffs.outer < 0.5) return;
  throw InputError({c.where("lubrication.outer_cutoff"), "lubrication.outer_cutoff must be below 0.5 with walls",
                    "the film between a sphere and a wall is described for gaps below the radius, d_eff being the "
                    "diameter there",
                    "lower it; 0.05 is the usual value"});
}

Vec3<double> box_of(double volume, const Vec3<double>& aspect) {
  return std::cbrt(volume / (aspect.x * aspect.y * aspect.z)) * aspect;
}

double smallest_radius(const Plan& plan) { return *std::min_element(plan.radii.begin(), plan.radii.end()); }

/// Of the films of the model and, d_eff being least for two of the smallest, of what the lattice does not resolve.
double film_reach(const Plan& plan) {
  double reach = plan.physics.lubrication_law == "none" ? 0.0 : plan.physics.cutoffs.outer;
  if (plan.resolved && plan.resolved->correction)
    reach = std::max(reach, plan.resolved->correction->range.outer * plan.resolved->cell / smallest_radius(plan));
  return reach;
}

constexpr double most_substeps = 100;

/// The lattice fixes the step; particles that need shorter ones take several in it.
void settle_resolved(const Case& c, Plan& plan) {
  plan.resolved = resolved_setup(c, plan.box, smallest_radius(plan));
  plan.physics.drag = plan.physics.stresslet = false;
  plan.time.step = plan.resolved->step();
  const double parts = std::ceil(plan.time.step / plan.bounds.chosen - 1e-9);
  if (parts > most_substeps)
    throw InputError({c.where("flow.reynolds"),
                      fmt::format("the particles would take {:.0f} steps in one of the lattice", parts),
                      fmt::format("a step of the lattice is {:.3g}, of the particles {:.3g}, limited by {}; the fluid "
                                  "cannot follow what happens in more than {:.0f}",
                                  plan.time.step, plan.bounds.chosen, plan.bounds.binding, most_substeps),
                      fmt::format("lower flow.reynolds to {:.3g}, the relaxation time, or contact.stiffness",
                                  c.reynolds_number() * most_substeps * plan.bounds.chosen / plan.time.step)});
  plan.time.substeps = std::max(1, int(parts));
}

double volume_of(std::vector<double> radii) {
  std::sort(radii.begin(), radii.end());  // the same bits in any order of the particles
  double sum = 0;
  for (double a : radii) sum += 4.0 / 3.0 * pi * a * a * a;
  return sum;
}

}  // namespace

double solid_fraction(const std::vector<double>& radii, const Box& box) { return volume_of(radii) / box.volume(); }

double Plan::memory_bytes() const {
  constexpr double program = 16e6;                           // code, libraries, buffers
  constexpr double per_particle = 900, per_candidate = 330;  // arrays of Suspension, by count of their entries
  const double reach = 2 * skin / (2 * *std::max_element(radii.begin(), radii.end()));
  const double candidates = double(count()) * (4 + 40 * solid_fraction * reach);
  const double lattice = resolved ? resolved_bytes(*resolved) : 0;
  return lattice + program + per_particle * double(count()) + per_candidate * candidates;
}

double Plan::expected_seconds(double strain) const {
  const double work = steps(strain) * double(count());
  const double speed_up = threads > 1 ? 0.8 * threads : 1.0;
  if (resolved) {
    return steps(strain) * (resolved->cell_count() * (1 + 4 * solid_fraction) / 4.5e7 + 2e-6 * double(count())) /
           speed_up;
  }
  if (time.scheme == "explicit") return work / (1.6e7 * (1.2 - solid_fraction) * speed_up);
  const double iterations = 3 + 0.8 * rough_viscosity(std::min(solid_fraction, 0.62), physics.contact.friction);
  return work * (1.1e-7 + 3.5e-8 * iterations) / speed_up;
}

Plan make_plan(const Case& c, const Existing* existing) {
  Plan plan;
  plan.density = c.stokes_number();
  plan.skin = skin;
  plan.threads = c.run.threads > 0 ? int(c.run.threads) : int(std::max(1u, std::thread::hardware_concurrency()));
  plan.box.kind = c.flow.boundary;
  if (existing) {
    plan.radii = existing->radii;
    plan.box.length = existing->box_length;
  } else if (c.suspension.file) {
    StartConfiguration start = read_start(c, plan.density);
    plan.loaded = std::move(start.state);
    plan.box = start.box;
    plan.radii.assign(plan.loaded.radius.begin(), plan.loaded.radius.end());
  } else {
    plan.sizes = make_sizes(c);
    check_reach(plan.sizes, *c.suspension.solid_fraction, c.where("suspension.solid_fraction"));
    for (const SizeClassed& s : plan.sizes) plan.radii.push_back(0.5 * s.diameter);
    const Vec3<double> aspect = c.suspension.box_aspect.value_or(Vec3<double>{1, 1, 1});
    const double volume = volume_of(plan.radii) / *c.suspension.solid_fraction;
    plan.box.length = box_of(volume, aspect);
    if (c.resolved()) {  // proportions in whole cells, the volume as it is
      const Cells n = cells_along(plan.box.length, *c.resolution->cells_per_diameter);
      plan.box.length = box_of(volume, {double(n[0]), double(n[1]), double(n[2])});
    }
  }
  plan.solid_fraction = solid_fraction(plan.radii, plan.box);
  plan.box.shear_rate = plan.box.kind == BoxKind::periodic ? 0.0 : 1.0;
  plan.physics = make_physics(c, c.suspension.solid_fraction.value_or(plan.solid_fraction));
  plan.bounds = step_bounds(plan.physics, c.time.scheme, plan.radii, plan.density);
  plan.time.scheme = c.time.scheme;
  if (c.resolved())
    settle_resolved(c, plan);
  else
    plan.time.step = settled_step(c, plan.bounds);
  plan.range = {film_reach(plan)};
  check_walls(c, plan);
  check_box(plan.box, *std::max_element(plan.radii.begin(), plan.radii.end()), plan.range, plan.skin,
            c.where(c.suspension.file ? "suspension.file" : "suspension.count"));
  return plan;
}

namespace {

void take(Suspension& s, const Plan& plan, ParticleState state) {
  s.state = std::move(state);
  s.state.fluid_density = plan.resolved ? plan.resolved->reynolds : 0;
}

}  // namespace

Suspension make_empty_suspension(const Plan& plan) {
  Suspension s;
  take(s, plan, {});
  s.physics = plan.physics;
  s.time = plan.time;
  s.box = plan.box;
  s.list = VerletList(plan.range, plan.skin);
  if (plan.resolved) s.resolved = std::make_shared<ResolvedFlow>(*plan.resolved);
  return s;
}

Suspension make_suspension(const Case& c, const Plan& plan, const std::function<void(double)>& report) {
  Suspension s = make_empty_suspension(plan);
  if (plan.sizes.empty()) {
    take(s, plan, plan.loaded);
    return s;
  }
  PackingRequest request;
  request.kind = plan.box.kind;
  request.aspect = c.resolved() ? plan.box.length : c.suspension.box_aspect.value_or(Vec3<double>{1, 1, 1});
  request.solid_fraction = *c.suspension.solid_fraction;
  request.seed = std::uint64_t(c.suspension.seed);
  request.shear_rate = plan.box.shear_rate;
  request.density = plan.density;
  request.where = c.where("suspension.solid_fraction");
  Packing packing = generate_packing(plan.sizes, request, report);
  take(s, plan, std::move(packing.state));
  s.box = packing.box;
  return s;
}

}  // namespace stresslet
