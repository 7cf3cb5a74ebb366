#pragma once
/// Input sections of a fluid case: [domain], [flow], [units], [lattice], [force], [initial], [solid], [run], [output].
///
/// Units of all keys: the reference length L, the reference velocity U and the density rho of the fluid; so times are
/// in L/U, pressures in rho U^2, force densities in rho U^2/L.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stresslet/io/schema.hpp"
#include "stresslet/simulation/commit_key.hpp"
#include "stresslet/simulation/fluid/case_choices.hpp"

namespace stresslet {

struct DomainInput {
  std::vector<double> size;
  std::int64_t resolution = 0;

  template <class V>
  void describe(V& v) {
    v.key("size", size, required, above_up_to(0, 1e6), "L",
          "Lengths along x, y and z; two numbers mean flow in the plane of x and y. Whole numbers of cells");
    v.key("resolution", resolution, required, between(1, 100'000), "1", "Cells in one reference length L");
  }

  int dimensions() const { return int(size.size()); }
  friend bool operator==(const DomainInput&, const DomainInput&) = default;
};

struct FluidFlowInput {
  std::optional<double> reynolds;

  template <class V>
  void describe(V& v) {
    v.key("reynolds", reynolds, otherwise("required unless [units] are given"), above_up_to(0, 1e9), "1",
          "Reynolds number U L / kinematic viscosity");
  }

  friend bool operator==(const FluidFlowInput&, const FluidFlowInput&) = default;
};

struct FluidUnitsInput {
  double length = 0, velocity = 0, kinematic_viscosity = 0, density = 0;

  template <class V>
  void describe(V& v) {
    v.key("length", length, required, above(0), "m", "The reference length L, unit of all lengths");
    v.key("velocity", velocity, required, above(0), "m/s", "The reference velocity U, unit of all velocities");
    v.key("kinematic_viscosity", kinematic_viscosity, required, above(0), "m2/s", "Kinematic viscosity of the fluid");
    v.key("density", density, required, above(0), "kg/m3", "Density of the fluid");
  }

  friend bool operator==(const FluidUnitsInput&, const FluidUnitsInput&) = default;
};

struct LatticeInput {
  std::optional<std::string> stencil;
  Precision precision = Precision::floating64;
  std::string collision = "TRT";
  double magic_parameter = 3.0 / 16;
  std::optional<double> relaxation_time, bulk_rate;
  double largest_mach = 0.1;
  std::array<std::int64_t, 3> blocks{1, 1, 1};

  template <class V>
  void describe(V& v) {
    v.key("stencil", stencil, otherwise("`\"D3Q19\"`, or `\"D2Q9\"` in two dimensions"), one_of(stencil_names()), "",
          "Set of discrete velocities");
    v.key("precision", precision, defaulted, anything(), "",
          "Precision of the populations; float32 halves the memory (D3Q19 only)");
    v.key("collision", collision, defaulted, one_of(collision_law_names()), "", "Collision law");
    v.key("magic_parameter", magic_parameter, defaulted, above_up_to(0, 10), "1",
          "TRT and MRT: (tau_even - 1/2)(tau_odd - 1/2). 3/16 puts half-way walls where they should be; 1/12 suits "
          "resolved particles");
    v.key("relaxation_time", relaxation_time, otherwise("1, or less where the Mach number demands it"),
          above_up_to(0.5, 100), "time step",
          "Relaxation time tau of the viscous stress, which fixes the time step. Verified from 0.51 to 3");
    v.key("bulk_rate", bulk_rate, otherwise("the rate of the shear stress"), strictly_between(0, 2), "1/time step",
          "MRT: relaxation rate of the trace of the stress, which sets the bulk viscosity");
    v.key("largest_mach", largest_mach, defaulted, above_up_to(0, 0.3), "1",
          "Largest Mach number of the fastest velocity of the input; errors grow with its square");
    v.key("blocks", blocks, defaulted, between(1, 1000), "1",
          "Blocks along x, y and z into which the domain is divided. Results do not depend on it");
  }

  friend bool operator==(const LatticeInput&, const LatticeInput&) = default;
};

struct ForceInput {
  std::optional<Vec3<double>> density, pressure_gradient;
  std::optional<double> womersley, angular_frequency;
  std::string law = "guo";

  template <class V>
  void describe(V& v) {
    v.key("density", density, otherwise("`pressure_gradient` is used"), anything(), "rho U^2/L",
          "Force on the fluid per volume; or give pressure_gradient");
    v.key("pressure_gradient", pressure_gradient, otherwise("`density` is used"), anything(), "rho U^2/L",
          "Mean gradient of the pressure, replaced by the opposite force");
    v.key("womersley", womersley, otherwise("the force is steady"), above(0), "1",
          "Makes the force oscillate as cos(omega t): L sqrt(omega / kinematic viscosity)");
    v.key("angular_frequency", angular_frequency, otherwise("the force is steady"), above(0), "U/L",
          "Makes the force oscillate as cos(omega t): omega; or give womersley");
    v.key("law", law, defaulted, one_of(body_force_law_names()), "", "How the force enters the collision");
  }

  friend bool operator==(const ForceInput&, const ForceInput&) = default;
};

struct InitialInput {
  std::string state = "rest";
  Vec3<double> velocity{};
  double amplitude = 1;
  std::optional<std::array<std::int64_t, 3>> waves;
  std::optional<InputPath> file;

  template <class V>
  void describe(V& v) {
    v.key("state", state, defaulted, one_of(initial_field_names()), "",
          "Flow at the start. In a sheared box, waves and vortices are added to the linear profile");
    v.key("velocity", velocity, defaulted, between(-100, 100), "U", "Uniform velocity added to it");
    v.key("amplitude", amplitude, defaulted, between(-100, 100), "U", "Velocity of waves and vortices");
    v.key("waves", waves, otherwise("`[0, 1, 0]` for shear-wave, `[1, 1, 0]` for taylor-green"), between(-1000, 1000),
          "1", "Waves in the box along x, y and z");
    v.key("file", file, otherwise("`state` is used"), anything(), "",
          "In place of `state`: fields of an earlier run on the same grid (fields/*.h5 with velocity and pressure)");
  }

  friend bool operator==(const InitialInput&, const InitialInput&) = default;
};

struct SolidInput {
  std::optional<std::vector<std::vector<double>>> spheres, cylinders, boxes;
  Axis cylinder_axis = Axis::z;
  std::optional<InputPath> file;

  template <class V>
  void describe(V& v) {
    v.key("spheres", spheres, otherwise("none"), anything(), "L", "A list [x, y, z, radius] for each sphere");
    v.key("cylinders", cylinders, otherwise("none"), anything(), "L",
          "A list [a, b, radius] for each endless cylinder, a and b the coordinates across its axis in the order x, y, "
          "z; discs in two dimensions");
    v.key("cylinder_axis", cylinder_axis, defaulted, anything(), "", "Direction of the cylinders");
    v.key("boxes", boxes, otherwise("none"), anything(), "L",
          "A list [x, y, z, x, y, z] for each box: its lowest and its highest corner");
    v.key(
        "file", file, otherwise("none"), anything(), "",
        "Voxels, one byte a cell, not 0 is solid: raw bytes with x fastest, .npy of shape (nz, ny, nx), or .h5 with a "
        "dataset `solid` of that shape");
  }

  friend bool operator==(const SolidInput&, const SolidInput&) = default;
};

struct FluidRunInput {
  double end_time = 0;
  std::optional<double> steady_tolerance;
  std::int64_t threads = 0;

  template <class V>
  void describe(V& v) {
    v.key("end_time", end_time, required, above_up_to(0, 1e9), "L/U",
          "Time at which the run ends; rounded to whole samples");
    v.key(
        "steady_tolerance", steady_tolerance, otherwise("the run goes on to `end_time`"), strictly_between(0, 1), "1",
        "Ends the run early once kinetic energy and dissipation of the last ten samples differ by this fraction only");
    v.key("threads", threads, defaulted, between(0, 1024), "1",
          "Threads; 0 takes all cores. Results do not depend on it");
  }

  friend bool operator==(const FluidRunInput&, const FluidRunInput&) = default;
};

struct FluidOutputInput {
  std::optional<double> sample_every, fields_every, profile_every;
  std::vector<std::string> fields{"velocity", "pressure"};
  std::optional<std::vector<double>> fields_from, fields_to;
  std::array<std::int64_t, 3> fields_stride{1, 1, 1};
  Axis profile_axis = Axis::y;
  std::optional<std::vector<std::vector<double>>> probes;
  double commit_every = 10;
  bool csv = true, paraview = true;

  template <class V>
  void describe(V& v) {
    v.key("sample_every", sample_every, otherwise("a 200th of `run.end_time`"), above(0), "L/U",
          "Time between two samples of the series; rounded to whole steps");
    v.key("fields_every", fields_every, otherwise("at the end only"), above(0), "L/U",
          "Time between two writes of the fields; rounded to whole steps");
    v.key("fields", fields, defaulted, one_of(field_names()), "", "Fields to write; none for an empty list");
    v.key("fields_from", fields_from, otherwise("the whole domain"), at_least(0), "L",
          "Lowest corner of the part of the domain that is written");
    v.key("fields_to", fields_to, otherwise("the whole domain"), at_least(0), "L",
          "Highest corner of the part of the domain that is written");
    v.key("fields_stride", fields_stride, defaulted, between(1, 10'000), "cells",
          "Writes every second, third, ... cell along x, y and z");
    v.key("profile_axis", profile_axis, defaulted, anything(), "",
          "Averages over the planes across this axis are kept as profiles");
    v.key("profile_every", profile_every, otherwise("at start and end only"), above(0), "L/U",
          "Time between two profiles; rounded to whole steps");
    v.key("probes", probes, otherwise("none"), at_least(0), "L",
          "Points, a list of coordinates for each: velocity and pressure of the cell there join the series");
    describe_commit_every(v, commit_every);
    v.key("csv", csv, defaulted, anything(), "", "Write the series as CSV too");
    v.key("paraview", paraview, defaulted, anything(), "", "Write what ParaView needs to open the fields");
  }

  friend bool operator==(const FluidOutputInput&, const FluidOutputInput&) = default;
};

}  // namespace stresslet
