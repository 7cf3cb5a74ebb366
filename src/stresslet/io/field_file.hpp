#pragma once
/// Fields on a regular grid at one time, each time in an HDF5 file of its own, and an XDMF file that shows them all to
/// ParaView.
///
///     fields/000001200.h5    attributes format = "stresslet fields", step, time, origin (3), spacing (3), in L;
///                            one dataset per field, shape (nz, ny, nx) or (nz, ny, nx, components);
///                            attributes unit, description; symmetric tensors as xx, xy, xz, yy, yz, zz
///     fields.xdmf            one time step per file
///
/// Every file is complete or absent: it is written beside its place and renamed.
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stresslet {

struct Field {
  std::string name, unit, description;
  int components = 1;
  std::vector<double> values;  ///< x fastest but for the components
};

struct FieldFile {
  std::int64_t step = 0;
  double time = 0;
  std::array<std::size_t, 3> count{};  ///< cells along x, y, z
  std::array<double, 3> origin{}, spacing{};
  std::vector<Field> fields;
};

inline constexpr const char* fields_folder = "fields";
inline constexpr const char* fields_xdmf_name = "fields.xdmf";

/// "000001200.h5".
std::string field_file_name(std::int64_t step);

/// Throws Error if it cannot be written.
void write_field_file(const std::filesystem::path& file, const FieldFile& content);
/// With `values` left out if `header_only`. InputError if it is missing, damaged or foreign.
FieldFile read_field_file(const std::filesystem::path& file, bool header_only = false);

/// The field files of a results folder up to a step, in order of time; others are not there (yet).
std::vector<FieldFile> field_headers(const std::filesystem::path& results, std::int64_t last_step);

/// XDMF text for files with these headers (`values` are not read).
std::string fields_xdmf_text(const std::vector<FieldFile>& headers);

/// Removes the field files after a step, parts of unfinished ones included: those that a run no longer knows of.
void remove_field_files(const std::filesystem::path& results, std::int64_t after_step);

}  // namespace stresslet
