#include "stresslet/simulation/fluid/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "stresslet/exec/huge_array.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/simulation/case_refusals.hpp"

namespace stresslet {

namespace {

constexpr double whole_cells = 1e-6;          // how far a length may be from whole cells
constexpr double largest_memory_share = 0.9;  // of the machine
constexpr double bytes_per_cell_of_a_sample = sizeof(CellState);
constexpr double cell_steps_per_second_and_thread = 5e7;  // D3Q19, float64; others by their number of populations

Cells grid_size(const FluidCase& c) {
  const double n = double(c.domain.resolution);
  const Vec3<double> box = c.box();
  const double lengths[3] = {box.x, box.y, box.z};
  Cells size;
  for (std::size_t a = 0; a < 3; ++a) {
    const double cells = lengths[a] * n, whole = std::max(std::round(cells), 1.0);
    if (std::abs(cells - whole) > whole_cells * whole)
      refuse(c.where("domain.size"), fmt::format("{} = {:.6g} L is {:.6g} cells long", "xyz"[a], lengths[a], cells),
             "the domain is divided into whole cells, domain.resolution of them in one L",
             fmt::format("nearest possible: {:.10g} L, or a resolution that makes it whole", whole / n));
    if (whole > 1e9)
      refuse(c.where("domain.size"), fmt::format("{:.3g} cells along {}", whole, "xyz"[a]), "no machine holds so many",
             "lower domain.resolution or the size");
    size[a] = int(whole);
  }
  return size;
}

Grid make_grid(const FluidCase& c) {
  Grid grid;
  grid.size = grid_size(c);
  for (std::size_t a = 0; a < 3; ++a) {
    if (c.boundaries.open(a)) grid.closure[a] = Closure::open;
    grid.blocks[a] = int(c.lattice.blocks[a]);
    if (grid.blocks[a] > grid.size[a])
      refuse(c.where("lattice.blocks"),
             fmt::format("{} blocks for {} cells along {}", grid.blocks[a], grid.size[a], "xyz"[a]),
             "every block needs a cell", "give fewer blocks");
  }
  if (c.boundaries.shear_rate) grid.closure[1] = Closure::sheared;
  return grid;
}

void set_faces(const FluidCase& c, const LatticeUnits& units, FluidSetup& setup) {
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t side = 0; side < 2; ++side) {
      const auto& face = c.boundaries.faces[a][side];
      if (!face) continue;
      FaceSetup& wall = setup.faces[a][side];
      wall.law = face->law;
      wall.velocity_lu = units.velocity * face->velocity.value_or(Vec3<double>{});
      wall.density_lu = 1 + 3 * units.pressure() * face->pressure.value_or(0);
    }
}

FluidSetup make_setup(const FluidCase& c, const LatticeUnits& units) {
  FluidSetup setup;
  setup.stencil = *c.lattice.stencil;
  setup.single_precision = c.lattice.precision == Precision::floating32;
  setup.grid = make_grid(c);
  setup.collision = c.lattice.collision;
  setup.rates = {units.relaxation_time, c.lattice.magic_parameter, c.lattice.bulk_rate, {}};
  if (c.force) setup.forcing = c.force->law;
  set_faces(c, units, setup);
  if (c.boundaries.shear_rate) {
    setup.shear_velocity_lu = *c.boundaries.shear_rate * c.box().y * units.velocity;
    setup.shear_interpolation = c.boundaries.shear_interpolation;
  }
  return setup;
}

double populations_of(const FluidSetup& setup) {
  double populations = 0;
  Stencils::dispatch(setup.stencil, [&](auto s) { populations = decltype(s)::type::size; });
  return populations;
}

Cells cell_at(const FluidCase& c, const Grid& grid, const std::vector<double>& point, std::string_view key) {
  Cells cell{0, 0, 0};
  for (std::size_t a = 0; a < point.size(); ++a) {
    const double x = point[a] * double(c.domain.resolution);
    if (x > grid.size[a] * (1 + whole_cells))
      refuse(c.where(key), fmt::format("{} lies outside the domain: {} = {:.6g}", key, "xyz"[a], point[a]),
             fmt::format("the domain ends at {:.6g} L", double(grid.size[a]) / double(c.domain.resolution)),
             "give a point inside, in units of L");
    cell[a] = std::clamp(int(std::floor(x)), 0, grid.size[a] - 1);
  }
  return cell;
}

CellBox fields_box(const FluidCase& c, const Grid& grid) {
  CellBox box{{0, 0, 0}, {grid.size[0] - 1, grid.size[1] - 1, grid.size[2] - 1}};
  if (c.output.fields_from) box.first = cell_at(c, grid, *c.output.fields_from, "output.fields_from");
  if (c.output.fields_to) {
    const Cells last = cell_at(c, grid, *c.output.fields_to, "output.fields_to");
    for (std::size_t a = 0; a < c.output.fields_to->size(); ++a) box.last[a] = last[a];
  }
  for (std::size_t a = 0; a < 3; ++a) {
    box.stride[a] = int(c.output.fields_stride[a]);
    if (box.first[a] > box.last[a])
      refuse(c.where("output.fields_from"), "output.fields_from lies above fields_to",
             fmt::format("along {} no cell lies between them", "xyz"[a]), "exchange or correct the two");
  }
  return box;
}

std::int64_t steps_in(double interval, const LatticeUnits& units) {
  return std::max<std::int64_t>(1, std::llround(interval / units.step));
}

void check_memory(const FluidCase& c, const FluidPlan& plan) {
  const double available = double(physical_memory());
  if (available == 0 || plan.memory_bytes() <= largest_memory_share * available) return;
  const double largest =
      std::floor(double(c.domain.resolution) *
                 std::pow(largest_memory_share * available / plan.memory_bytes(), 1.0 / c.domain.dimensions()));
  refuse(c.where("domain.resolution"),
         fmt::format("the grid of {} x {} x {} cells needs {:.4g} GB of memory", plan.setup.grid.size[0],
                     plan.setup.grid.size[1], plan.setup.grid.size[2], plan.memory_bytes() / 1e9),
         fmt::format("this machine has {:.3g} GB, of which a run may take nine tenths", available / 1e9),
         fmt::format("nearest possible: a resolution of about {:.0f}; lattice.precision = \"float32\" takes less",
                     largest));
}

}  // namespace

double FluidPlan::cells() const {
  const Cells& n = setup.grid.size;
  return double(n[0]) * double(n[1]) * double(n[2]);
}

double FluidPlan::memory_bytes() const {
  const double halo = setup.stencil == D2Q9::name ? 0 : 2;
  const Cells& n = setup.grid.size;
  const double stored = (n[0] + 2.0) * (n[1] + 2.0) * (n[2] + halo) * populations_of(setup) *
                        (setup.single_precision ? sizeof(float) : sizeof(double));
  const double checkpoint = cells() * populations_of(setup) * sizeof(double);
  return stored + checkpoint + bytes_per_cell_of_a_sample * cells();
}

double FluidPlan::expected_seconds() const {
  const double rate = cell_steps_per_second_and_thread * std::min(threads, 8) * 19 / populations_of(setup) *
                      (setup.single_precision ? 1.8 : 1);
  constexpr double sample_cost = 8;  // of a sample, in steps
  return cells() * (double(steps) + sample_cost * double(steps) / double(sample_every)) / rate;
}

Vec3<double> FluidPlan::force_lu(std::int64_t step) const {
  return (units.force_density() * std::cos(angular_frequency * time(step))) * force;
}

FluidPlan make_plan(const FluidCase& c) {
  FluidPlan plan;
  plan.reynolds = c.reynolds_number();
  const LatticeChoice choice{plan.reynolds, c.domain.resolution, c.fastest_velocity(), c.lattice.largest_mach,
                             c.lattice.relaxation_time};
  if (const auto why = impossible(choice))
    refuse(c.where(c.lattice.relaxation_time ? "lattice.relaxation_time" : "flow.reynolds"), why->problem, why->reason,
           why->nearest);
  plan.units = lattice_units(choice);
  plan.setup = make_setup(c, plan.units);
  if (c.force) {
    plan.force = c.force->density ? *c.force->density : -1.0 * *c.force->pressure_gradient;
    if (c.force->angular_frequency) plan.angular_frequency = *c.force->angular_frequency;
    if (c.force->womersley) plan.angular_frequency = *c.force->womersley * *c.force->womersley / plan.reynolds;
  }
  plan.sample_every = steps_in(*c.output.sample_every, plan.units);
  plan.steps = std::max<std::int64_t>(1, std::llround(c.run.end_time / (plan.units.step * double(plan.sample_every)))) *
               plan.sample_every;
  if (c.output.fields_every) plan.fields_every = steps_in(*c.output.fields_every, plan.units);
  if (c.output.profile_every) plan.profile_every = steps_in(*c.output.profile_every, plan.units);
  plan.fields_box = fields_box(c, plan.setup.grid);
  if (c.output.probes)
    for (const auto& point : *c.output.probes)
      plan.probes.push_back(cell_at(c, plan.setup.grid, point, "output.probes"));
  plan.threads = c.run.threads > 0 ? int(c.run.threads) : int(std::max(1u, std::thread::hardware_concurrency()));
  check_memory(c, plan);
  return plan;
}

}  // namespace stresslet
