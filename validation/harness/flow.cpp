#include "validation/harness/flow.hpp"

#include <algorithm>
#include <cmath>

#include "stresslet/base/error.hpp"

namespace stresslet::validation {

FluidSetup periodic_box(const std::string& stencil, const Cells& size, const std::string& collision,
                        double relaxation_time) {
  FluidSetup setup;
  setup.stencil = stencil;
  setup.grid.size = size;
  setup.collision = collision;
  setup.rates.relaxation_time = relaxation_time;
  return setup;
}

void add_walls(FluidSetup& setup, int axis, const Vec3<double>& low_velocity_lu, const Vec3<double>& high_velocity_lu) {
  setup.grid.closure[std::size_t(axis)] = Closure::open;
  setup.faces[std::size_t(axis)] = {FaceSetup{"half-way", low_velocity_lu, 1},
                                    FaceSetup{"half-way", high_velocity_lu, 1}};
}

Flow::Flow(Trial& trial, const FluidSetup& setup, std::string label)
    : trial_(trial), label_(std::move(label)), fluid_(Fluid::make(setup)) {}

void Flow::advance(int steps) {
  constexpr int together = 256;
  for (int done = 0; done < steps; done += together) {
    fluid_->advance(trial_.team(), std::min(together, steps - done));
    if (trial_.progress().due()) trial_.progress().show(fmt::format("  {}: step {}", label_, fluid_->steps()));
  }
}

void Flow::advance_to_steady(double tolerance, int interval, int limit) {
  std::vector<CellState> before = states();
  while (fluid_->steps() < limit) {
    advance(interval);
    std::vector<CellState> now = states();
    double change = 0, speed = 0;
    for (std::size_t k = 0; k < now.size(); ++k) {
      change = std::max(change, norm(now[k].velocity - before[k].velocity));
      speed = std::max(speed, norm(now[k].velocity));
    }
    if (change <= tolerance * speed) return;
    before = std::move(now);
  }
  throw NumericalFailure({label_, fmt::format("the flow is not steady after {} steps", limit),
                          "the reference is a steady state", "report this as a bug"});
}

std::vector<CellState> Flow::states() {
  std::vector<CellState> all(cell_count(size()));
  fluid_->measure(trial_.team(), {0, 0, 0}, {size()[0] - 1, size()[1] - 1, size()[2] - 1}, {1, 1, 1},
                  [&](const Cells& c, const CellState& s) { all[cell_number(size(), c)] = s; });
  return all;
}

}  // namespace stresslet::validation
