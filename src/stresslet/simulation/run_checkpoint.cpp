#include "stresslet/simulation/run_checkpoint.hpp"

#include "stresslet/simulation/stored.hpp"

namespace stresslet {

void add_run_state(Checkpoint& checkpoint, const ProfileSums& profile, const RunCost& cost) {
  checkpoint.arrays["profile_volume"] = profile.volume;
  checkpoint.arrays["profile_volume_velocity"] = profile.volume_velocity;
  checkpoint.scalars["profile_frames"] = profile.frames;
  checkpoint.scalars["profile_slope_yy"] = profile.slope_yy;
  checkpoint.scalars["profile_slope_yu"] = profile.slope_yu;
  checkpoint.scalars["wall_seconds"] = cost.wall_seconds;
  checkpoint.scalars["particle_steps"] = cost.particle_steps;
}

ProfileSums profile_sums(const Checkpoint& c) {
  return {stored<double>(c.scalars, "profile_frames"), stored<std::vector<double>>(c.arrays, "profile_volume"),
          stored<std::vector<double>>(c.arrays, "profile_volume_velocity"),
          stored<double>(c.scalars, "profile_slope_yy"), stored<double>(c.scalars, "profile_slope_yu")};
}

RunCost run_cost(const Checkpoint& c) {
  return {stored<double>(c.scalars, "wall_seconds"), stored<double>(c.scalars, "particle_steps"), {}};
}

Series restored_series(const ResultsReader& reader, FluidColumns fluid) {
  std::vector<std::vector<double>> columns;
  for (const Column& c : series_columns(fluid)) columns.push_back(reader.series(c.name));
  Series series(fluid);
  std::vector<double> row(columns.size());
  for (std::size_t k = 0; k < columns.front().size(); ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c) row[c] = columns[c][k];
    series.restore(row);
  }
  return series;
}

void set_profiles(ResultsFolder& results, const ShearProfile& profile) {
  const std::size_t slabs = profile.height().size();
  const auto set = [&](const char* name, const char* unit, const char* description, std::vector<double> values) {
    results.set_profile({name, unit, description, {slabs}, std::move(values)});
  };
  set("height", "d", "middle of the layer, along the velocity gradient", profile.height());
  set("solid_fraction", "1", "solid fraction of the layer, mean over the averaging window", profile.solid_fraction());
  set("velocity", "d*shear_rate", "velocity u_x of the spheres in the layer, weighted by volume", profile.velocity());
}

Plan make_restart_plan(const Case& settled, const ResultsReader& reader) {
  const Checkpoint c = reader.checkpoint();
  const Existing existing{stored<std::vector<double>>(c.arrays, "state_radius"),
                          {stored<double>(c.scalars, "box_length_x"), stored<double>(c.scalars, "box_length_y"),
                           stored<double>(c.scalars, "box_length_z")}};
  return make_plan(settled, &existing);
}

}  // namespace stresslet
