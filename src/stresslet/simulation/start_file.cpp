#include "stresslet/simulation/start_file.hpp"

#include <filesystem>

#include "stresslet/base/error.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"
#include "stresslet/particles/packing/from_columns.hpp"

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

}  // namespace

StartConfiguration read_start(const Case& settled, double density) {
  const std::filesystem::path path = settled.suspension.file->text;
  StartConfiguration start;
  start.box.kind = settled.flow.boundary;
  start.box.shear_rate = start.box.kind == BoxKind::periodic ? 0.0 : 1.0;
  bool has_box = settled.suspension.box.has_value();
  if (has_box) start.box.length = *settled.suspension.box;

  ParticleColumns columns;
  if (path.extension() == ".csv") {
    columns = columns_of(read_csv(path));
  } else {
    const XyzFrame frame = read_last_xyz_frame(path);
    columns = columns_of(frame);
    if (frame.box && !has_box) {
      start.box.length = {frame.box->length[0], frame.box->length[1], frame.box->length[2]};
      if (start.box.kind == BoxKind::lees_edwards) start.box.offset = frame.box->offset;
      has_box = true;
    }
  }
  if (!has_box)
    throw InputError({settled.where("suspension.file"), "no box: " + path.string() + " does not give one",
                      "the solid fraction and all images follow from the lengths of the box",
                      "add box = [Lx, Ly, Lz] to [suspension], or a Lattice to an extended XYZ file"});
  ColumnLimits limits;
  limits.density = density;
  start.state = state_from_columns(columns, start.box, limits, path.string());
  return start;
}

Table::Params read_size_table(const InputPath& file, ShareKind shares) {
  const CsvTable table = read_csv(file.text);
  return {table.column("diameter"), table.column("share"),
          shares == ShareKind::number ? Table::Basis::number : Table::Basis::volume};
}

}  // namespace stresslet
