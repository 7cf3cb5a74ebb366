#pragma once
/// Input sections about what is sheared and how: [suspension], [suspension.sizes], [flow], [units].
#include <cstdint>
#include <optional>
#include <vector>

#include "stresslet/base/vec3.hpp"
#include "stresslet/io/schema.hpp"
#include "stresslet/simulation/case_choices.hpp"

namespace stresslet {

struct SizesInput {
  SizeLaw law = SizeLaw::discrete;
  std::optional<std::vector<double>> diameters, volume_shares, number_shares;
  std::optional<double> median_diameter, sigma, smallest, largest;
  std::optional<InputPath> file;
  std::optional<ShareKind> shares;

  template <class V>
  void describe(V& v) {
    v.key("law", law, defaulted, anything(), "",
          "Kind of size distribution: one size (diameter 1), a list of sizes, lognormal, or a table in a file");
    v.key("diameters", diameters, otherwise("`[1.0, 1.4]` for law = \"discrete\""), above(0), "d1",
          "Diameters of the sizes of a discrete distribution");
    v.key("volume_shares", volume_shares, otherwise("`[0.5, 0.5]` for law = \"discrete\" without `diameters`"),
          above_up_to(0, 1), "1", "Share of each size in the volume of all particles; or give number_shares");
    v.key("number_shares", number_shares, otherwise("volume_shares is used"), above_up_to(0, 1), "1",
          "Share of each size in the number of particles; or give volume_shares");
    v.key("median_diameter", median_diameter, otherwise("required for law = \"lognormal\""), above(0), "d1",
          "Median diameter, by number, of a lognormal distribution");
    v.key("sigma", sigma, otherwise("required for law = \"lognormal\""), above_up_to(0, 2), "1",
          "Standard deviation of the logarithm of the diameter");
    v.key("smallest", smallest, otherwise("required for law = \"lognormal\""), above(0), "d1",
          "Smaller diameters of a lognormal distribution are left out");
    v.key("largest", largest, otherwise("required for law = \"lognormal\""), above(0), "d1",
          "Larger diameters of a lognormal distribution are left out");
    v.key("file", file, otherwise("required for law = \"table\""), anything(), "",
          "CSV file with the columns diameter (in d1) and share");
    v.key("shares", shares, otherwise("required for law = \"table\""), anything(), "",
          "Whether the shares of the table count particles or their volume");
  }

  friend bool operator==(const SizesInput&, const SizesInput&) = default;
};

struct SuspensionInput {
  std::optional<double> solid_fraction;
  std::optional<std::int64_t> count;
  std::int64_t seed = 1;
  std::optional<Vec3<double>> box_aspect, box;
  std::optional<InputPath> file;
  std::optional<SizesInput> sizes;

  template <class V>
  void describe(V& v) {
    v.key("solid_fraction", solid_fraction, otherwise("required unless `file` is given"), strictly_between(0, 1), "1",
          "Volume of the particles over volume of the box");
    v.key("count", count, otherwise("`1000` unless `file` is given"), between(2, 100'000'000), "1",
          "Number of particles; the box follows from it");
    v.key("seed", seed, defaulted, at_least(0), "1", "Start of the random numbers; another seed is another packing");
    v.key("box_aspect", box_aspect, otherwise("`[1.0, 1.0, 1.0]` unless `file` is given"), between(0.01, 100), "1",
          "Proportions of the box along flow, gradient and vorticity");
    v.key("file", file, otherwise("a random packing is made"), anything(), "",
          "Start configuration, results.h5 of a run, extended XYZ or CSV, in place of solid_fraction, count, "
          "box_aspect and sizes");
    v.key("box", box, otherwise("that of `file`, which a CSV does not have"), above(0), "d1",
          "Lengths of the box for the start configuration in `file`");
    v.section("sizes", sizes,
              "Size distribution. Left out, it is two sizes, 1 : 1.4, with equal volumes, which does not crystallise.");
  }

  friend bool operator==(const SuspensionInput&, const SuspensionInput&) = default;
};

struct FlowInput {
  BoxKind boundary = BoxKind::lees_edwards;
  std::optional<double> stokes, reynolds;

  template <class V>
  void describe(V& v) {
    v.key("boundary", boundary, defaulted, anything(), "",
          "Sheared periodic box, moving flat walls across the gradient, or periodic without shear");
    v.key("stokes", stokes, otherwise("`0.1`, or derived from [units]"), above(0), "1",
          "Stokes number, density d1^2 shear rate / viscosity: inertia of the particles. Results no longer depend on "
          "it below about 0.1");
    v.key("reynolds", reynolds, otherwise("the Stokes number: fluid and particles of one density"), above(0), "1",
          "Reynolds number, density of the fluid d1^2 shear rate / viscosity; with fidelity = \"resolved\" only");
  }

  friend bool operator==(const FlowInput&, const FlowInput&) = default;
};

struct UnitsInput {
  double diameter = 0, viscosity = 0, shear_rate = 0, density = 0;

  template <class V>
  void describe(V& v) {
    v.key("diameter", diameter, required, above(0), "m", "The diameter d1, unit of all lengths");
    v.key("viscosity", viscosity, required, above(0), "Pa s", "Dynamic viscosity of the fluid");
    v.key("shear_rate", shear_rate, required, above(0), "1/s", "Shear rate");
    v.key("density", density, required, above(0), "kg/m3", "Density of the particles");
  }

  friend bool operator==(const UnitsInput&, const UnitsInput&) = default;
};

}  // namespace stresslet
