/// Rules that tie several keys of a fluid case together. What one key may be on its own stands in its description.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stresslet/lattice/laws.hpp"
#include "stresslet/simulation/case_refusals.hpp"
#include "stresslet/simulation/fluid/case.hpp"

namespace stresslet {
namespace {

void check_domain(const FluidCase& read) {
  const std::size_t dimensions = read.domain.size.size();
  if (dimensions != 2 && dimensions != 3)
    refuse(read.where("domain.size"), fmt::format("domain.size has {} entries", dimensions),
           "a flow has two or three dimensions", "give [Lx, Ly, Lz], or [Lx, Ly] for flow in the plane of x and y");
  if (!read.lattice.stencil) return;
  const bool flat = *read.lattice.stencil == D2Q9::name;
  if (flat != (dimensions == 2))
    refuse(read.where("lattice.stencil"),
           fmt::format("lattice.stencil = \"{}\" does not go with a domain of {} dimensions", *read.lattice.stencil,
                       dimensions),
           fmt::format("the number of lengths in domain.size at {} sets the dimensions", read.where("domain.size")),
           "leave lattice.stencil out, or give domain.size as many lengths as the stencil has dimensions");
}

void check_flow(const FluidCase& read) {
  if (read.units && read.flow.reynolds)
    refuse_both(read, "flow.reynolds", "units", "the Reynolds number follows from the four values of [units]");
  if (!read.units && !read.flow.reynolds)
    refuse(read.where("flow.reynolds"), "flow.reynolds is missing", "it sets the viscosity and has no default",
           "add reynolds = ... (U L / kinematic viscosity) to [flow], or give the four values of [units]");
  const double reynolds = read.reynolds_number();
  if (!std::isfinite(reynolds) || !(reynolds > 0))
    refuse(read.where("units"), "the Reynolds number of [units] is zero or not finite",
           "length velocity / kinematic_viscosity under- or overflows",
           "check the powers of ten: all values are in SI units");
}

void check_lattice(const FluidCase& read) {
  const LatticeInput& lattice = read.lattice;
  if (lattice.bulk_rate && lattice.collision != Mrt::name)
    refuse(read.where("lattice.bulk_rate"), "lattice.bulk_rate has no effect",
           fmt::format("it belongs to collision = \"MRT\", but the law is \"{}\"", lattice.collision),
           "remove it, or write collision = \"MRT\" in [lattice]");
  const bool three_dimensional = read.domain.dimensions() == 3 && lattice.stencil.value_or("D3Q19") == D3Q19::name;
  if (lattice.precision == Precision::floating32 && !three_dimensional)
    refuse(read.where("lattice.precision"), "lattice.precision = \"float32\" needs the stencil D3Q19",
           "single precision is built for it only", "remove it, or use D3Q19 in three dimensions");
}

void check_force(const FluidCase& read) {
  if (!read.force) return;
  const ForceInput& force = *read.force;
  if (force.density && force.pressure_gradient)
    refuse_both(read, "force.density", "force.pressure_gradient", "each of them fixes the force on the fluid");
  if (!force.density && !force.pressure_gradient)
    refuse(read.where("force"), "[force] has neither density nor pressure_gradient", "one of them is the force",
           "add density = [fx, fy, fz] in rho U^2/L, or remove [force]");
  if (force.womersley && force.angular_frequency)
    refuse_both(read, "force.womersley", "force.angular_frequency", "each of them fixes the frequency");
}

std::string face_key(std::size_t axis, std::size_t side) {
  return fmt::format("boundaries.{}", BoundariesInput::face_names[axis][side]);
}

void check_face(const FluidCase& read, std::size_t axis, std::size_t side) {
  const FaceInput& face = *read.boundaries.faces[axis][side];
  const std::string key = face_key(axis, side);
  const BoundaryKind kind = boundary_kind(face.law);
  if (face.pressure && kind != BoundaryKind::pressure)
    refuse(read.where(key + ".pressure"), key + ".pressure has no effect",
           fmt::format("the law \"{}\" sets no pressure", face.law),
           "remove it, or choose a law that sets the pressure");
  const Vec3<double> u = face.velocity.value_or(Vec3<double>{});
  const double normal = axis == 0 ? u.x : axis == 1 ? u.y : u.z;
  if (kind == BoundaryKind::wall && normal != 0)
    refuse(read.where(key + ".velocity"), fmt::format("the wall {} moves through itself", key),
           fmt::format("its velocity along {} is {}, and would pump mass", "xyz"[axis], normal),
           "give a velocity along the wall, or choose the law \"velocity\" for fluid that comes in");
  if (kind == BoundaryKind::pressure && normal != 0)
    refuse(read.where(key + ".velocity"),
           fmt::format("{} sets both the pressure and the velocity through the face", key),
           "the one follows from the other", "give a velocity along the face only, or choose the law \"velocity\"");
}

void check_boundaries(const FluidCase& read) {
  if (read.boundaries.shear_rate && (read.boundaries.faces[0][0] || read.boundaries.faces[0][1]))
    refuse(read.where("boundaries.shear_rate"), "a sheared box must be periodic along x",
           "its image is displaced along x, and would carry the faces along",
           "remove the faces across x, or the shear rate");
  std::size_t opening_axis = 3;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto& [low, high] = read.boundaries.faces[axis];
    if (low.has_value() != high.has_value()) {
      const std::string given = face_key(axis, low ? 0 : 1), missing = face_key(axis, low ? 1 : 0);
      refuse(read.where(given), fmt::format("{} is given without {}", given, missing),
             "an axis is periodic across both of its faces, or across none",
             fmt::format("add [{}], or remove [{}]", missing, given));
    }
    if (!low) continue;
    if (axis == 2 && read.domain.dimensions() == 2)
      refuse(read.where(face_key(axis, 0)), "faces across z are given for a flow in the plane of x and y",
             "two-dimensional flow has none", "remove them, or give domain.size three lengths");
    if (axis == 1 && read.boundaries.shear_rate)
      refuse(read.where(face_key(axis, 0)), "both boundaries.shear_rate and faces across y are given",
             fmt::format("a sheared box is periodic across y; the shear rate is given at {}",
                         read.where("boundaries.shear_rate")),
             "remove the faces for a sheared box, or the shear rate and let the walls move");
    for (std::size_t side = 0; side < 2; ++side) {
      check_face(read, axis, side);
      if (boundary_kind(read.boundaries.faces[axis][side]->law) == BoundaryKind::wall) continue;
      if (opening_axis < 3 && opening_axis != axis)
        refuse(read.where(face_key(axis, side)), "openings on faces of two axes",
               "neither would know all it needs in the edge that they share", "keep openings to the faces of one axis");
      opening_axis = axis;
    }
  }
}

void check_initial(const FluidCase& read) {
  const InitialInput& initial = read.initial;
  if (initial.file && initial.state != "rest")
    refuse_both(read, "initial.state", "initial.file", "each of them is the flow at the start");
  const bool waves = initial.state == "shear-wave" || initial.state == "taylor-green";
  if (initial.waves && !waves)
    refuse(read.where("initial.waves"), "initial.waves has no effect",
           fmt::format("the state \"{}\" has no waves", initial.state), "remove it, or choose a state that has");
  if (initial.waves && *initial.waves == std::array<std::int64_t, 3>{0, 0, 0})
    refuse(read.where("initial.waves"), "initial.waves is zero", "a wave needs a direction",
           "give one number other than 0");
  if (initial.state == "taylor-green" && initial.waves && ((*initial.waves)[0] == 0 || (*initial.waves)[1] == 0))
    refuse(read.where("initial.waves"), "Taylor-Green vortices need waves along x and along y",
           "each vortex is as long as half a wave", "give two numbers other than 0, such as [1, 1, 0]");
  if (initial.state == "linear" && !read.boundaries.open(1) && !read.boundaries.shear_rate)
    refuse(read.where("initial.state"), "a linear profile needs faces across y, or a sheared box",
           "it joins their velocities", "describe [boundaries.y_low] and [boundaries.y_high], or give shear_rate");
}

void check_rows(const FluidCase& read, std::string_view key, const std::vector<std::vector<double>>& rows,
                std::size_t entries, std::string_view meaning) {
  const double longest = *std::max_element(read.domain.size.begin(), read.domain.size.end());
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k].size() != entries)
      refuse(read.where(key), fmt::format("entry {} of {} has {} numbers", k + 1, key, rows[k].size()),
             fmt::format("{} are needed: {}", entries, meaning), "correct the entry");
    for (const double number : rows[k])
      if (std::abs(number) > 10 * longest)
        refuse(read.where(key), fmt::format("entry {} of {} holds {:.6g}", k + 1, key, number),
               "that is far outside the domain; lengths are in L", "correct the entry");
  }
}

void check_solid(const FluidCase& read) {
  if (!read.solid) return;
  const SolidInput& solid = *read.solid;
  if (!solid.spheres && !solid.cylinders && !solid.boxes && !solid.file)
    refuse(read.where("solid"), "[solid] names no body", "nothing would be solid",
           "add spheres, cylinders, boxes or file, or remove [solid]");
  if (solid.spheres) check_rows(read, "solid.spheres", *solid.spheres, 4, "x, y, z, radius");
  if (solid.cylinders)
    check_rows(read, "solid.cylinders", *solid.cylinders, 3, "two coordinates across the axis and the radius");
  if (solid.boxes) check_rows(read, "solid.boxes", *solid.boxes, 6, "the lowest and the highest corner");
  const auto check_radii = [&](std::string_view key, const auto& rows) {
    if (!rows) return;
    for (const auto& row : *rows)
      if (!(row.back() > 0))
        refuse(read.where(key), fmt::format("a radius in {} is {}", key, row.back()), "a body has a size",
               "give a radius > 0");
  };
  check_radii("solid.spheres", solid.spheres);
  check_radii("solid.cylinders", solid.cylinders);
}

void check_point(const FluidCase& read, std::string_view key, const std::optional<std::vector<double>>& point) {
  if (point && point->size() != std::size_t(read.domain.dimensions()))
    refuse(read.where(key), fmt::format("{} has {} entries", key, point->size()),
           fmt::format("the domain has {} dimensions", read.domain.dimensions()), "give one coordinate for each");
}

void check_output(const FluidCase& read) {
  const FluidOutputInput& output = read.output;
  if (output.sample_every && *output.sample_every > read.run.end_time)
    refuse(read.where("output.sample_every"),
           fmt::format("output.sample_every = {} exceeds run.end_time = {}", *output.sample_every, read.run.end_time),
           "the run would end before the first sample", "lower it, or raise run.end_time");
  check_point(read, "output.fields_from", output.fields_from);
  check_point(read, "output.fields_to", output.fields_to);
  if (output.probes)
    check_rows(read, "output.probes", *output.probes, std::size_t(read.domain.dimensions()),
               "the coordinates of a point");
}

}  // namespace

void check_fluid_case(const FluidCase& read) {
  check_domain(read);
  check_flow(read);
  check_lattice(read);
  check_force(read);
  check_boundaries(read);
  check_initial(read);
  check_solid(read);
  check_output(read);
}

}  // namespace stresslet
