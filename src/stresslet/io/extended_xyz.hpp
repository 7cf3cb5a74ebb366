#pragma once
/// Particles as extended XYZ, the format that OVITO opens: one frame per snapshot.
///
/// The second lattice vector carries the shear, (offset reduced to the nearest image, Ly, 0). Columns: id, species,
/// pos, radius, velo, angular_velocity.
#include <filesystem>
#include <optional>
#include <string>

#include "stresslet/io/results_data.hpp"

namespace stresslet {

/// One frame as text; numbers are exact on reading back.
std::string xyz_frame(const Snapshot& snapshot);

/// A frame as found in a file; what the file does not give stays empty.
struct XyzFrame {
  std::optional<BoxGeometry> box;
  std::optional<double> strain, time;
  std::vector<double> position;                    ///< (N, 3)
  std::vector<double> velocity, angular_velocity;  ///< (N, 3) or empty
  std::vector<double> radius;                      ///< (N) or empty
  std::vector<std::int32_t> species, id;           ///< (N) or empty; species named by text count 0, 1, ... as they come
  std::size_t first_line = 0;                      ///< line in the file of the first particle, for messages

  std::size_t size() const { return position.size() / 3; }
};

/// The last frame of the file. InputError with file:line for anything that is not extended XYZ with positions.
XyzFrame read_last_xyz_frame(const std::filesystem::path& file);

}  // namespace stresslet
