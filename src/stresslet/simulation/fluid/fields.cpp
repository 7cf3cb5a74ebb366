#include "stresslet/simulation/fluid/fields.hpp"

#include <algorithm>

namespace stresslet {

namespace {

void append(std::vector<double>& values, double factor, const SymTensor3<double>& s) {
  for (const double v : {s.xx, s.xy, s.xz, s.yy, s.yz, s.zz}) values.push_back(factor * v);
}

void append_value(std::vector<double>& values, std::string_view name, const CellState& s, bool solid,
                  const FluidPlan& plan) {
  const LatticeUnits& u = plan.units;
  if (name == "velocity")
    for (const double v : {s.velocity.x, s.velocity.y, s.velocity.z}) values.push_back(v / u.velocity);
  else if (name == "pressure")
    values.push_back((s.density - 1) / (3 * u.pressure()));
  else if (name == "density")
    values.push_back(s.density);
  else if (name == "strain_rate")
    append(values, 1 / u.rate(), s.strain_rate);
  else if (name == "viscous_stress")
    append(values, 2 * s.density / (plan.reynolds * u.rate()), s.strain_rate);
  else
    values.push_back(solid);
}

}  // namespace

FieldFile make_fields(const FlowField& field, const FluidPlan& plan, const std::vector<std::string>& names,
                      const CellBox& box, std::int64_t step) {
  FieldFile file;
  file.step = step;
  file.time = plan.time(step);
  for (std::size_t a = 0; a < 3; ++a) {
    file.count[a] = std::size_t(box.count(a));
    file.spacing[a] = plan.units.cell * box.stride[a];
    // A written cell stands for `stride` cells around its centre.
    file.origin[a] = plan.units.cell * (box.first[a] + 0.5 - 0.5 * box.stride[a]);
  }
  for (const FieldKind& kind : field_kinds) {
    if (std::find(names.begin(), names.end(), kind.name) == names.end()) continue;
    Field values{std::string(kind.name), std::string(kind.unit), std::string(kind.description), kind.components, {}};
    values.values.reserve(box.count() * std::size_t(kind.components));
    for (int z = box.first[2]; z <= box.last[2]; z += box.stride[2])
      for (int y = box.first[1]; y <= box.last[1]; y += box.stride[1])
        for (int x = box.first[0]; x <= box.last[0]; x += box.stride[0])
          append_value(values.values, kind.name, field[{x, y, z}], field.is_solid({x, y, z}), plan);
    file.fields.push_back(std::move(values));
  }
  // In the order in which they are read back.
  std::sort(file.fields.begin(), file.fields.end(), [](const Field& a, const Field& b) { return a.name < b.name; });
  return file;
}

}  // namespace stresslet
