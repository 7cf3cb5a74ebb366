#pragma once
/// Input sections [boundaries] and [boundaries.x_low] ... [boundaries.z_high]: how the faces of the domain close.
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "stresslet/io/schema.hpp"
#include "stresslet/simulation/fluid/case_choices.hpp"

namespace stresslet {

struct FaceInput {
  std::string law = "half-way";
  std::optional<Vec3<double>> velocity;
  std::optional<double> pressure;

  template <class V>
  void describe(V& v) {
    v.key("law", law, defaulted, one_of(boundary_law_names()), "", "Boundary law");
    v.key("velocity", velocity, otherwise("`[0.0, 0.0, 0.0]`"), between(-100, 100), "U",
          "Velocity of the wall, or of the fluid at the face");
    v.key("pressure", pressure, otherwise("`0.0`"), anything(), "rho U^2",
          "Pressure at the face, for laws that set it");
  }

  friend bool operator==(const FaceInput&, const FaceInput&) = default;
};

struct BoundariesInput {
  std::optional<double> shear_rate;
  std::string shear_interpolation = "cubic";
  std::array<std::array<std::optional<FaceInput>, 2>, 3> faces;  ///< [axis][0 low, 1 high]

  static constexpr std::string_view face_names[3][2] = {{"x_low", "x_high"}, {"y_low", "y_high"}, {"z_low", "z_high"}};
  static constexpr std::string_view face_docs[3][2] = {{"The face at x = 0.", "The face at the far end of x."},
                                                       {"The face at y = 0.", "The face at the far end of y."},
                                                       {"The face at z = 0.", "The face at the far end of z."}};

  template <class V>
  void describe(V& v) {
    v.key("shear_rate", shear_rate, otherwise("no sheared box"), between(-1e6, 1e6), "U/L",
          "Shears a periodic box (Lees-Edwards): mean velocity shear_rate (y - Ly/2) along x");
    v.key("shear_interpolation", shear_interpolation, defaulted, one_of(shear_interpolation_names()), "",
          "Interpolation between the cells of the box and those of its displaced image");
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t side = 0; side < 2; ++side)
        v.section(face_names[axis][side], faces[axis][side], face_docs[axis][side]);
  }

  bool open(std::size_t axis) const { return faces[axis][0] && faces[axis][1]; }
  friend bool operator==(const BoundariesInput&, const BoundariesInput&) = default;
};

}  // namespace stresslet
