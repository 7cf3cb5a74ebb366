#pragma once
/// Small made-up results for the output tests: every number follows from the index of sample, snapshot and particle.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "stresslet/io/results_data.hpp"

namespace stresslet::output_samples {

/// A fresh folder, removed with all it holds at the end of the scope.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "stresslet-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::vector<Column> columns() {
  return {{"strain", "1", "accumulated shear strain"},
          {"time", "1/shear rate", "time"},
          {"relative_viscosity", "1", "shear stress over that of the fluid"}};
}

inline std::vector<double> sample(std::size_t k) {
  const double strain = double(k) / 3;
  return {strain, 2 * strain, 1 + strain * strain};
}

inline Snapshot snapshot(std::size_t k, std::size_t particles = 7) {
  Snapshot s;
  s.strain = double(k) / 7;
  s.time = 2 * s.strain;
  s.box = {{3, 4, 5}, 0.1 * double(k % 30), true};
  for (std::size_t i = 0; i < particles; ++i) {
    s.id.push_back(std::int32_t(i));
    s.species.push_back(std::int32_t(i % 2));
    s.radius.push_back(i % 2 ? 0.7 : 0.5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = double(100 * k + 10 * i + axis);
      s.position.push_back(x / 3);
      s.velocity.push_back(-x / 7);
      s.angular_velocity.push_back(1 / (1 + x));
    }
  }
  return s;
}

/// The contact arrays change their length from one checkpoint to the next, as contacts open and close.
inline Checkpoint checkpoint(std::size_t k, std::size_t contacts = 5) {
  Checkpoint c;
  c.arrays["x"] = std::vector<double>{1.0 / 3, double(k), -0.0};
  c.arrays["contact_history"] = std::vector<double>(3 * (contacts + k % 4), double(k) / 9);
  c.arrays["contact_first"] = std::vector<std::int32_t>(contacts + k % 4, std::int32_t(k));
  c.arrays["random_state"] = std::vector<std::int64_t>{-(std::int64_t(1) << 62) - std::int64_t(k), 3};
  c.arrays["empty"] = std::vector<double>{};
  c.scalars["strain"] = double(k) / 3;
  c.scalars["commits"] = std::int64_t(k);
  return c;
}

}  // namespace stresslet::output_samples
