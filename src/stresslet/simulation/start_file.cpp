#include "stresslet/simulation/start_file.hpp"

#include <filesystem>

#include "stresslet/base/error.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"
#include "stresslet/io/results_file.hpp"
#include "stresslet/particles/packing/from_columns.hpp"
#include "stresslet/simulation/stored.hpp"

namespace stresslet {

namespace {

/// Column c of a row-major (N, 3) array; empty for an empty array.
std::vector<double> component(const std::vector<double>& rows, std::size_t c) {
  std::vector<double> column;
  for (std::size_t k = c; k < rows.size(); k += 3) column.push_back(rows[k]);
  return column;
}

std::vector<double> optional_column(const CsvTable& table, const std::string& name) {
  return table.has(name) ? table.column(name) : std::vector<double>{};
}

template <class Integer>
std::vector<Integer> whole_numbers(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

ParticleColumns columns_of(const CsvTable& table) {
  ParticleColumns c;
  c.x = table.column("x"), c.y = table.column("y"), c.z = table.column("z");
  if (table.has("diameter") && !table.has("radius"))
    for (double d : table.column("diameter")) c.radius.push_back(0.5 * d);
  else
    c.radius = table.column("radius");
  c.ux = optional_column(table, "ux"), c.uy = optional_column(table, "uy"), c.uz = optional_column(table, "uz");
  c.wx = optional_column(table, "wx"), c.wy = optional_column(table, "wy"), c.wz = optional_column(table, "wz");
  c.species = whole_numbers<std::int32_t>(optional_column(table, "species"));
  c.id = whole_numbers<std::int64_t>(optional_column(table, "id"));
  return c;
}

ParticleColumns columns_of(const XyzFrame& frame) {
  ParticleColumns c;
  c.x = component(frame.position, 0), c.y = component(frame.position, 1), c.z = component(frame.position, 2);
  c.radius = frame.radius;
  c.ux = component(frame.velocity, 0), c.uy = component(frame.velocity, 1), c.uz = component(frame.velocity, 2);
  c.wx = component(frame.angular_velocity, 0), c.wy = component(frame.angular_velocity, 1);
  c.wz = component(frame.angular_velocity, 2);
  c.species = frame.species;
  c.id.assign(frame.id.begin(), frame.id.end());
  return c;
}

ParticleColumns columns_of(const Checkpoint& checkpoint) {
  const auto column = [&](const char* name) {
    return stored<std::vector<double>>(checkpoint.arrays, std::string("state_") + name);
  };
  ParticleColumns c;
  c.x = column("x"), c.y = column("y"), c.z = column("z"), c.radius = column("radius");
  c.ux = column("ux"), c.uy = column("uy"), c.uz = column("uz");
  c.wx = column("wx"), c.wy = column("wy"), c.wz = column("wz");
  c.species = stored<std::vector<std::int32_t>>(checkpoint.arrays, "state_species");
  const auto& id = stored<std::vector<std::int32_t>>(checkpoint.arrays, "state_id");
  c.id.assign(id.begin(), id.end());
  return c;
}

BoxGeometry box_of(const Checkpoint& checkpoint) {
  const auto scalar = [&](const char* name) { return stored<double>(checkpoint.scalars, name); };
  return {{scalar("box_length_x"), scalar("box_length_y"), scalar("box_length_z")}, scalar("box_offset")};
}

/// Particles of a file, and its box where it has one.
struct FileContent {
  ParticleColumns columns;
  std::optional<BoxGeometry> box;
};

FileContent read_content(const std::filesystem::path& path) {
  if (path.extension() == ".csv") return {columns_of(read_csv(path)), std::nullopt};
  if (path.extension() == ".h5") {
    const Checkpoint checkpoint = ResultsReader(path).checkpoint();
    return {columns_of(checkpoint), box_of(checkpoint)};
  }
  const XyzFrame frame = read_last_xyz_frame(path);
  return {columns_of(frame), frame.box};
}

}  // namespace

StartConfiguration read_start(const Case& settled, double density) {
  const std::filesystem::path path = settled.suspension.file->text;
  StartConfiguration start;
  start.box.kind = settled.flow.boundary;
  start.box.shear_rate = start.box.kind == BoxKind::periodic ? 0.0 : 1.0;
  const FileContent content = read_content(path);
  if (settled.suspension.box) {
    start.box.length = *settled.suspension.box;
  } else if (content.box) {
    start.box.length = {content.box->length[0], content.box->length[1], content.box->length[2]};
    if (start.box.kind == BoxKind::lees_edwards) start.box.offset = content.box->offset;
  } else
    throw InputError({settled.where("suspension.file"), "no box: " + path.string() + " does not give one",
                      "the solid fraction and all images follow from the lengths of the box",
                      "add box = [Lx, Ly, Lz] to [suspension], or a Lattice to an extended XYZ file"});
  ColumnLimits limits;
  limits.density = density;
  start.state = state_from_columns(content.columns, start.box, limits, path.string());
  return start;
}

Table::Params read_size_table(const InputPath& file, ShareKind shares) {
  const CsvTable table = read_csv(file.text);
  return {table.column("diameter"), table.column("share"),
          shares == ShareKind::number ? Table::Basis::number : Table::Basis::volume};
}

}  // namespace stresslet
