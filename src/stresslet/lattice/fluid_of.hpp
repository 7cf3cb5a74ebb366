#pragma once
/// The fluid of one stencil and precision: what stands behind the facade of fluid.hpp.
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include "stresslet/lattice/boundary/make_boundaries.hpp"
#include "stresslet/lattice/cell_state.hpp"
#include "stresslet/lattice/fluid.hpp"
#include "stresslet/lattice/laws.hpp"
#include "stresslet/lattice/step.hpp"
#include "stresslet/lattice/sweep.hpp"

namespace stresslet {

/// Measures one cell, for the chosen forcing law and stencil.
template <class Stencil>
using StateOf = CellState (*)(const CellPopulations<Stencil, double>&, const RelaxationRates&,
                              const BodyForce<double>&);

template <class Stencil, class T>
class FluidOf : public Fluid {
 public:
  explicit FluidOf(const FluidSetup& setup)
      : lattice_(setup.grid),
        boundaries_(make_boundaries<Stencil, T>(setup, lattice_)),
        sweep_(sweep_for<Stencil, T>(setup.collision, setup.forcing)),
        solid_(setup.solid) {
    CollisionLaws::dispatch(setup.collision,
                            [&](auto c) { lattice_.input.rates = decltype(c)::type::rates(setup.rates); });
    ForcingLaws::dispatch(setup.forcing, [&](auto f) { state_of_ = state_of<Stencil, typename decltype(f)::type>; });
    lattice_.shear_velocity = setup.shear_velocity_lu;
  }

  const Grid& grid() const override { return lattice_.grid; }
  std::int64_t steps() const override { return lattice_.steps; }
  std::size_t bytes() const override {
    std::size_t sum = solid_.size();
    for (const auto& block : lattice_.blocks) sum += block.populations.bytes();
    return sum;
  }

  void set_force_density(const Vec3<double>& force_lu) override { lattice_.input.force_density = force_lu; }
  void set_shear_offset(double offset_lu) override { lattice_.shear_offset = lattice_.departure_offset = offset_lu; }
  double shear_offset() const override { return lattice_.shear_offset; }

  void initialise(ThreadTeam& team, const std::function<CellState(const Cells&)>& state) override {
    lattice_.arrangement = Arrangement::arrived;
    lattice_.steps = 0;
    const BodyForce<double> force = body_force();
    for_each_cell(team, [&](const auto& block, const Cells& global, std::size_t index) {
      const auto f =
          populations_of<Stencil>(is_solid(global) ? CellState{} : state(global), lattice_.input.rates, force);
      for (int i = 0; i < Stencil::size; ++i) block.populations.slot(i)[index] = T(f[i]);
    });
    for (const auto& boundary : boundaries_.others) boundary->initialise(lattice_);
  }

  void advance(ThreadTeam& team, int steps) override {
    team.run([&](Member& member) {
      for (int n = 0; n < steps; ++n) step(lattice_, sweep_, boundaries_, member);
    });
  }

  void measure(ThreadTeam& team, const Cells& first, const Cells& last, const Cells& stride,
               const std::function<void(const Cells&, const CellState&)>& visit) override {
    prepare(team);
    const BodyForce<double> force = body_force();
    for_each_cell(team, [&](const auto& block, const Cells& global, std::size_t index) {
      for (int a = 0; a < 3; ++a)
        if (global[a] < first[a] || global[a] > last[a] || (global[a] - first[a]) % stride[a] != 0) return;
      visit(global, is_solid(global) ? CellState{}
                                     : state_of_(incoming(block.populations, lattice_.arrangement, index),
                                                 lattice_.input.rates, force));
    });
  }

  Totals totals(ThreadTeam& team) override {
    prepare(team);
    const Cells& n = grid().size;
    // Summed cell by cell in order, so that neither blocks nor threads show in the bits.
    std::vector<CellPopulationsMoments> cells(cell_count(grid().size));
    for_each_cell(team, [&](const auto& block, const Cells& global, std::size_t index) {
      const auto m = moments_of(incoming(block.populations, lattice_.arrangement, index));
      if (!is_solid(global)) cells[cell_number(grid().size, global)] = {m.density_deviation, m.momentum};
    });
    Totals sum;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const double deviation = cells[k].density_deviation;
      const Vec3<double>& momentum = cells[k].momentum;
      sum.mass_deviation += deviation;
      sum.momentum += momentum;
      const bool finite = std::isfinite(deviation) && std::isfinite(dot(momentum, momentum));
      sum.see({int(k % std::size_t(n[0])), int(k / std::size_t(n[0]) % std::size_t(n[1])),
               int(k / (std::size_t(n[0]) * std::size_t(n[1])))},
              1 + deviation, finite);
    }
    return sum;
  }

  std::vector<double> populations(ThreadTeam& team) override {
    prepare(team);
    const std::size_t cells = cell_count(grid().size);
    std::vector<double> all(cells * Stencil::size + kept());
    for_each_cell(team, [&](const auto& block, const Cells& global, std::size_t index) {
      if (is_solid(global)) return;
      for (int i = 0; i < Stencil::size; ++i)
        all[std::size_t(i) * cells + cell_number(grid().size, global)] =
            block.populations.source(i, lattice_.arrangement)[index];
    });
    double* at = all.data() + cells * Stencil::size;
    for (const auto& boundary : boundaries_.others) {
      boundary->save(lattice_, at);
      at += boundary->kept();
    }
    return all;
  }

  void restore(ThreadTeam& team, const std::vector<double>& all, std::int64_t steps) override {
    const std::size_t cells = cell_count(grid().size);
    if (all.size() != cells * Stencil::size + kept())
      throw std::invalid_argument("populations of another grid, stencil or set of walls");
    lattice_.arrangement = Arrangement::arrived;
    lattice_.steps = steps;
    for_each_cell(team, [&](const auto& block, const Cells& global, std::size_t index) {
      for (int i = 0; i < Stencil::size; ++i)
        block.populations.slot(i)[index] = T(all[std::size_t(i) * cells + cell_number(grid().size, global)]);
    });
    const double* at = all.data() + cells * Stencil::size;
    for (const auto& boundary : boundaries_.others) {
      boundary->restore(lattice_, at);
      at += boundary->kept();
    }
  }

 protected:
  struct CellPopulationsMoments {
    double density_deviation = 0;
    Vec3<double> momentum{};
  };

  std::size_t kept() const {
    std::size_t sum = 0;
    for (const auto& boundary : boundaries_.others) sum += boundary->kept();
    return sum;
  }
  bool is_solid(const Cells& c) const { return !solid_.empty() && solid_[cell_number(grid().size, c)]; }
  BodyForce<double> body_force() const { return {lattice_.input.force_density, lattice_.input.rates.odd}; }

  void prepare(ThreadTeam& team) {
    team.run([&](Member& member) { prepare_step(lattice_, boundaries_, member); });
  }

  /// Calls `body(block, global coordinates, index)` for every cell, rows shared among the threads.
  template <class Body>
  void for_each_cell(ThreadTeam& team, Body&& body) {
    team.run([&](Member& member) {
      for_each_row(lattice_, member, [&](auto& block, int y, int z) {
        const BlockLayout& layout = block.populations.layout();
        for (int x = 0; x < layout.size()[0]; ++x)
          body(block, Cells{block.origin[0] + x, block.origin[1] + y, block.origin[2] + z}, layout.index(x, y, z));
      });
    });
  }

  Lattice<Stencil, T> lattice_;
  Boundaries<Stencil, T> boundaries_;
  Sweep<Stencil, T> sweep_;
  StateOf<Stencil> state_of_ = nullptr;
  std::vector<std::uint8_t> solid_;
};

}  // namespace stresslet
