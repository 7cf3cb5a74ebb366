#include "stresslet/simulation/fluid/plane_averages.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace stresslet {

namespace {

constexpr std::array<const char*, 4> plane_columns{"velocity_x", "velocity_y", "velocity_z", "pressure"};

}  // namespace

void PlaneAverages::add(const FlowField& field, std::int64_t step) {
  const std::size_t a = std::size_t(axis_), b = a == 0 ? 1 : 0, c = a == 2 ? 1 : 2;
  const LatticeUnits& u = plan_.units;
  time_.push_back(plan_.time(step));
  for (int plane = 0; plane < field.size()[a]; ++plane) {
    double cells = 0, density_deviation = 0;
    Vec3<double> velocity{};
    Cells at;
    at[a] = plane;
    for (at[c] = 0; at[c] < field.size()[c]; ++at[c])
      for (at[b] = 0; at[b] < field.size()[b]; ++at[b]) {
        if (field.is_solid(at)) continue;
        cells += 1;
        velocity += field[at].velocity;
        density_deviation += field[at].density - 1;
      }
    cells = std::max(cells, 1.0);
    const double averages[4] = {velocity.x / (u.velocity * cells), velocity.y / (u.velocity * cells),
                                velocity.z / (u.velocity * cells), density_deviation / (3 * u.pressure() * cells)};
    for (std::size_t k = 0; k < plane_columns.size(); ++k) values_[k].push_back(averages[k]);
  }
}

std::vector<Profile> PlaneAverages::profiles() const {
  const char axis = "xyz"[std::size_t(axis_)];
  const std::size_t planes = std::size_t(plan_.setup.grid.size[std::size_t(axis_)]);
  std::vector<double> position(planes);
  for (std::size_t k = 0; k < planes; ++k) position[k] = (double(k) + 0.5) * plan_.units.cell;
  std::vector<Profile> all{
      {"position", "L", fmt::format("{} of the centres of the cells", axis), {planes}, std::move(position)},
      {"time", "L/U", "times of the averages", {time_.size()}, time_}};
  for (std::size_t k = 0; k < plane_columns.size(); ++k)
    all.push_back({plane_columns[k],
                   k < 3 ? "U" : "rho*U^2",
                   fmt::format("average over the fluid of the planes across {}", axis),
                   {time_.size(), planes},
                   values_[k]});
  return all;
}

void PlaneAverages::restore(const ResultsReader& reader) {
  time_ = reader.profile("time").values;
  for (std::size_t k = 0; k < plane_columns.size(); ++k) values_[k] = reader.profile(plane_columns[k]).values;
  if (plan_.profile_every > 0) return;
  // Start and end only: what was the end is none any more.
  time_.resize(1);
  for (auto& values : values_) values.resize(std::size_t(plan_.setup.grid.size[std::size_t(axis_)]));
}

}  // namespace stresslet
