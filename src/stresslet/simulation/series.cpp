#include "stresslet/simulation/series.hpp"

#include <algorithm>
#include <stdexcept>

namespace stresslet {

namespace {

constexpr const char* stress_unit = "viscosity*shear_rate";

void for_each_component(const Stress& s, auto&& visit) {
  visit("xx", s.xx), visit("yy", s.yy), visit("zz", s.zz), visit("xy", s.xy), visit("xz", s.xz), visit("yz", s.yz);
}

/// Visits (name, unit, description, value) of every column: the one list behind names and rows.
template <class Visit>
void for_each_quantity(double strain, const Sample& m, double energy_rate, double particles, double solver_iterations,
                       FluidColumns columns, const FluidSample& fluid, Visit&& visit) {
  const Stress total = m.stress.total();
  visit("strain", "1", "shear strain", strain);
  visit("time", "1/shear_rate", "time", strain);
  visit("relative_viscosity", "1", "1 + sigma_xy of all parts", 1 + total.xy);
  visit("relative_viscosity_from_dissipation", "1",
        "1 + dissipation, stresslet and growth of stored energy over viscosity*shear_rate^2",
        1 + m.stress.stresslet.xy + m.dissipation() + energy_rate);
  visit("N1", stress_unit, "first normal stress difference, sigma_xx - sigma_yy", total.xx - total.yy);
  visit("N2", stress_unit, "second normal stress difference, sigma_yy - sigma_zz", total.yy - total.zz);
  visit("particle_pressure", stress_unit, "minus a third of the trace of the particles' stress", -trace(total) / 3);
  StressParts::for_each(m.stress, [&](const char* part, const Stress& stress) {
    for_each_component(stress, [&](const char* axes, double value) {
      visit(std::string(part) + "_" + axes, stress_unit, std::string("stress, part ") + part, value);
    });
  });
  visit("dissipation_lubrication", "viscosity*shear_rate^2", "power lost in films, per volume",
        m.dissipation_lubrication);
  visit("dissipation_sliding", "viscosity*shear_rate^2", "power lost in sliding contacts, per volume",
        m.dissipation_sliding);
  visit("dissipation_dashpot", "viscosity*shear_rate^2", "power lost in contact dashpots, per volume",
        m.dissipation_dashpot);
  visit("dissipation_drag", "viscosity*shear_rate^2",
        "power lost to Stokes drag, per volume; in a resolved fluid, its dissipation less that of the mean flow "
        "and the stresslet",
        m.dissipation_drag);
  visit("elastic_energy", "viscosity*shear_rate", "energy of the contacts, per volume", m.elastic_energy);
  visit("kinetic_energy", "viscosity*shear_rate", "kinetic energy relative to the mean flow, per volume",
        m.kinetic_energy);
  visit("momentum_x", "viscosity*d^2", "momentum relative to the mean flow, all particles", m.momentum.x);
  visit("momentum_y", "viscosity*d^2", "momentum relative to the mean flow, all particles", m.momentum.y);
  visit("momentum_z", "viscosity*d^2", "momentum relative to the mean flow, all particles", m.momentum.z);
  visit("contacts_per_particle", "1", "contacts that a particle has on average", 2 * m.contacts / particles);
  visit("largest_overlap", "1", "largest overlap over the smaller diameter of its pair", m.largest_overlap);
  visit("solver_iterations", "1", "iterations of the last velocity solve", solver_iterations);
  if (columns == FluidColumns::none) return;
  visit("lowest_density", "1", "lowest density of a cell over that at rest", fluid.lowest_density);
  visit("highest_density", "1", "highest density of a cell over that at rest", fluid.highest_density);
  visit("kinetic_stresslet_xy", stress_unit,
        "part of stresslet_xy; less this it is the usual first moment of the force on the fluid",
        fluid.kinetic_stresslet);
  StressParts::for_each(fluid.virtual_films, [&](const std::string& part, const Stress& stress) {
    if (part.starts_with("lubrication"))
      visit("virtual_" + part + "_xy", stress_unit,
            "what the lubricated model would make of these positions and velocities, part " + part, stress.xy);
  });
  if (columns != FluidColumns::resolved_and_sheared) return;
  visit(
      "stored_momentum", "viscosity",
      "first moment across the box of the momentum relative to the mean flow, per volume; its growth is what the flux "
      "through the plane exceeds the stress by",
      fluid.stored_momentum);
  visit("relative_viscosity_through_plane", "1",
        "flux of momentum through the sheared plane, or what walls feel, over viscosity*shear_rate; independent of the "
        "summed "
        "stress",
        fluid.viscosity_through_plane);
}

}  // namespace

std::vector<Column> series_columns(FluidColumns fluid) {
  std::vector<Column> columns;
  for_each_quantity(0, {}, 0, 1, 0, fluid, {},
                    [&](std::string name, std::string unit, std::string description, double) {
                      columns.push_back({std::move(name), std::move(unit), std::move(description)});
                    });
  return columns;
}

Series::Series(FluidColumns fluid) : fluid_(fluid) {
  for (const Column& c : series_columns(fluid)) names_.push_back(c.name);
  columns_.resize(names_.size());
}

bool Series::has(const std::string& column) const {
  return std::find(names_.begin(), names_.end(), column) != names_.end();
}

const std::vector<double>& Series::operator[](const std::string& column) const {
  const auto found = std::find(names_.begin(), names_.end(), column);
  if (found == names_.end()) throw std::out_of_range("no column " + column);
  return columns_[std::size_t(found - names_.begin())];
}

double Series::last(const std::string& column) const { return (*this)[column].back(); }

const std::vector<double>& Series::add(double strain, const Sample& sample, double particles, double solver_iterations,
                                       const FluidSample& fluid) {
  double energy_rate = 0;
  if (size() > 0) {
    const double before = last("elastic_energy") + last("kinetic_energy");
    energy_rate = (sample.elastic_energy + sample.kinetic_energy - before) / (strain - last("strain"));
  }
  row_.clear();
  for_each_quantity(strain, sample, energy_rate, particles, solver_iterations, fluid_, fluid,
                    [&](const std::string&, const char*, const std::string&, double value) { row_.push_back(value); });
  restore(row_);
  return row_;
}

void Series::restore(const std::vector<double>& row) {
  for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].push_back(row[c]);
}

std::size_t Series::first_row_from(double strain) const {
  const auto& strains = columns_.front();
  return std::size_t(std::lower_bound(strains.begin(), strains.end(), strain - 1e-9) - strains.begin());
}

}  // namespace stresslet
