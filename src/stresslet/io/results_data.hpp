#pragma once
/// What a run hands to its output, as plain data. Units: docs/user-guide.md; in short length d, time 1/shear rate.
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace stresslet {

/// One column of the time series.
struct Column {
  std::string name, unit, description;
  friend bool operator==(const Column&, const Column&) = default;
};

/// The box as files describe it: origin at zero, image above displaced by `offset` in x.
struct BoxGeometry {
  std::array<double, 3> length{1, 1, 1};
  double offset = 0;
  bool periodic_in_y = true;
};

/// All particles at one strain, in ascending order of `id`, which counts 0 ... N-1.
struct Snapshot {
  double strain = 0, time = 0;
  BoxGeometry box;
  std::vector<double> position, velocity, angular_velocity;  ///< (N, 3)
  std::vector<double> radius;                                ///< (N)
  std::vector<std::int32_t> species, id;                     ///< (N)

  std::size_t size() const { return id.size(); }
};

/// A profile or distribution: the newest version replaces the one before. Row-major, one or two dimensions.
struct Profile {
  std::string name, unit, description;
  std::vector<std::size_t> shape;
  std::vector<double> values;
};

/// All that a run needs to go on bit for bit; the names (without '/') are the caller's.
struct Checkpoint {
  using Array = std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>>;
  using Scalar = std::variant<double, std::int64_t>;

  std::int32_t format_version = 1;
  std::map<std::string, Array> arrays;
  std::map<std::string, Scalar> scalars;

  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

}  // namespace stresslet
