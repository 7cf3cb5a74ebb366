#include "stresslet/simulation/fluid/start.hpp"

#include <fmt/format.h>

#include <numbers>
#include <stdexcept>

#include "stresslet/io/field_file.hpp"
#include "stresslet/simulation/case_refusals.hpp"
#include "stresslet/simulation/fluid/initial_fields.hpp"
#include "stresslet/simulation/fluid/solid_mask.hpp"

namespace stresslet {

namespace {

InitialParameters initial_parameters(const FluidCase& c) {
  const Vec3<double> box = c.box();
  InitialParameters p;
  p.amplitude = c.initial.amplitude;
  if (c.initial.waves) {
    const auto& waves = *c.initial.waves;
    const double turn = 2 * std::numbers::pi;
    p.wave_vector = {turn * double(waves[0]) / box.x, turn * double(waves[1]) / box.y, turn * double(waves[2]) / box.z};
  }
  p.height = box.y;
  if (c.boundaries.shear_rate) {
    p.high_velocity.x = *c.boundaries.shear_rate * box.y / 2;
    p.low_velocity = -p.high_velocity;
  } else if (c.boundaries.open(1)) {
    p.low_velocity = c.boundaries.faces[1][0]->velocity.value_or(Vec3<double>{});
    p.high_velocity = c.boundaries.faces[1][1]->velocity.value_or(Vec3<double>{});
  }
  return p;
}

/// The sum of the named flow and the mean flow of the sheared box, in the units of the program.
template <class State>
InitialFlow flow_at(const Vec3<double>& x, const InitialParameters& p, bool on_mean_flow) {
  InitialFlow flow = State::at(x, p);
  if (on_mean_flow) {
    const InitialFlow mean = Linear::at(x, p);
    flow.velocity += mean.velocity;
    flow.strain_rate += mean.strain_rate;
  }
  return flow;
}

CellState lattice_state(const InitialFlow& flow, const LatticeUnits& u) {
  return {1 + 3 * u.pressure() * flow.pressure, u.velocity * flow.velocity, u.rate() * flow.strain_rate};
}

void fill_from_file(Fluid& fluid, const FluidCase& c, const FluidPlan& plan, ThreadTeam& team) {
  const FieldFile file = read_field_file(c.initial.file->text);
  const Cells& n = fluid.grid().size;
  const auto find = [&](const char* name, int components) -> const std::vector<double>& {
    for (const Field& field : file.fields)
      if (field.name == name && field.components == components) return field.values;
    refuse(c.where("initial.file"), fmt::format("{} holds no field '{}'", c.initial.file->text, name),
           "the start needs velocity and pressure", "write both in output.fields of the earlier run");
  };
  const std::vector<double>& velocity = find("velocity", 3);
  const std::vector<double>& pressure = find("pressure", 1);
  if (file.count != std::array{std::size_t(n[0]), std::size_t(n[1]), std::size_t(n[2])})
    refuse(c.where("initial.file"),
           fmt::format("the fields have {} x {} x {} cells", file.count[0], file.count[1], file.count[2]),
           fmt::format("the domain has {} x {} x {}", n[0], n[1], n[2]),
           "give fields of the same grid, all of its cells");
  fluid.initialise(team, [&](const Cells& cell) {
    const std::size_t k = cell_number(n, cell);
    InitialFlow flow{{velocity[3 * k], velocity[3 * k + 1], velocity[3 * k + 2]}, pressure[k], {}};
    flow.velocity += c.initial.velocity;
    return lattice_state(flow, plan.units);
  });
}

}  // namespace

FluidSetup complete_setup(const FluidCase& settled, const FluidPlan& plan) {
  FluidSetup setup = plan.setup;
  setup.solid = solid_mask(settled, setup.grid);
  return setup;
}

std::unique_ptr<Fluid> make_fluid(const FluidCase& settled, const FluidSetup& setup) {
  try {
    return Fluid::make(setup);
  } catch (const std::invalid_argument& why) {
    refuse(settled.source.document.name(), "this combination of laws and boundaries is not built", why.what(),
           "choose others; 'stresslet list laws' names them");
  } catch (const std::bad_alloc&) {
    refuse(settled.where("domain.resolution"), "the memory for the populations is not to be had",
           "other programs use it, or a limit is set", "lower domain.resolution");
  }
}

void fill(Fluid& fluid, const FluidCase& c, const FluidPlan& plan, ThreadTeam& team) {
  fluid.set_force_density(plan.force_lu(0));
  if (c.initial.file) {
    fill_from_file(fluid, c, plan, team);
    return;
  }
  const InitialParameters parameters = initial_parameters(c);
  const double cell = plan.units.cell;
  InitialFields::dispatch(c.initial.state, [&](auto tag) {
    using State = typename decltype(tag)::type;
    const bool on_mean_flow = c.boundaries.shear_rate && State::is_disturbance;
    fluid.initialise(team, [&](const Cells& at) {
      const Vec3<double> x{(at[0] + 0.5) * cell, (at[1] + 0.5) * cell, (at[2] + 0.5) * cell};
      InitialFlow flow = flow_at<State>(x, parameters, on_mean_flow);
      flow.velocity += c.initial.velocity;
      return lattice_state(flow, plan.units);
    });
  });
}

}  // namespace stresslet
