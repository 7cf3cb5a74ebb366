#pragma once
/// Whether two result folders hold the same bytes, but for what the clock decides.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "../program.hpp"
#include "stresslet/io/results_file.hpp"

namespace stresslet::program {

/// Restart state without what the clock decides.
inline Checkpoint timeless(Checkpoint checkpoint) {
  checkpoint.scalars.erase("wall_seconds");
  return checkpoint;
}

inline nlohmann::json timeless_summary(const std::string& folder) {
  nlohmann::json summary = nlohmann::json::parse(content_of(folder + "/summary.json"));
  for (const char* cost : {"wall_seconds", "particle_steps_per_second", "seconds_per_unit_strain",
                           "lattice_updates_per_second", "time_share"})
    summary.erase(cost);
  return summary;
}

inline void expect_same_results(const std::string& folder, const std::string& reference) {
  const ResultsReader a(folder + "/results.h5"), b(reference + "/results.h5");
  ASSERT_EQ(a.sample_count(), b.sample_count());
  for (const Column& column : b.columns()) EXPECT_EQ(a.series(column.name), b.series(column.name)) << column.name;
  ASSERT_EQ(a.snapshot_count(), b.snapshot_count());
  for (std::size_t k = 0; k < b.snapshot_count(); ++k) {
    EXPECT_EQ(a.snapshot(k).position, b.snapshot(k).position) << k;
    EXPECT_EQ(a.snapshot(k).velocity, b.snapshot(k).velocity) << k;
  }
  for (const std::string& name : b.profile_names()) EXPECT_EQ(a.profile(name).values, b.profile(name).values) << name;
  EXPECT_TRUE(timeless(a.checkpoint()) == timeless(b.checkpoint())) << "restart states differ";
  for (const char* file : {"series.csv", "particles.xyz", "particles.xdmf"})
    EXPECT_TRUE(content_of(folder + "/" + file) == content_of(reference + "/" + file)) << file;
  EXPECT_EQ(timeless_summary(folder), timeless_summary(reference));
}

}  // namespace stresslet::program
