/// Laws, stencils, precisions and input files of fluid cases, each through the real program: plane Poiseuille flow
/// against its parabola, solids from voxel files, and a start from the fields of an earlier run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "../program.hpp"
#include "stresslet/io/field_file.hpp"
#include "stresslet/io/results_file.hpp"

namespace stresslet {
namespace {

using namespace program;

/// Unit height, viscosity 1/10 and force 0.8: the parabola 4 y (1 - y), drifting with the walls.
constexpr const char* channel = R"(fidelity = "fluid"
[domain]
size = [0.25, 1, 0.25]
resolution = 16
[flow]
reynolds = 10
[lattice]
relaxation_time = 0.75
magic_parameter = 0.1875
[force]
density = [0.8, 0, 0]
[boundaries.y_low]
velocity = [0.25, 0, 0]
[boundaries.y_high]
velocity = [0.25, 0, 0]
[initial]
velocity = [0.25, 0, 0]
[run]
end_time = 8
[output]
profile_every = 8
fields_every = 8
fields = ["velocity", "pressure", "solid"]
)";

struct Choice {
  const char* name;
  std::vector<std::string> keys;
  double tolerance;  ///< of the largest velocity
};
std::ostream& operator<<(std::ostream& out, const Choice& choice) { return out << choice.name; }

class FluidLaw : public ::testing::TestWithParam<Choice> {};

TEST_P(FluidLaw, ChannelFlowIsTheParabola) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel), results = place / "results";
  const Outcome run = stresslet(run_arguments(input, results, GetParam().keys));
  ASSERT_EQ(run.code, 0) << run.err;
  const auto profile = ResultsReader(results + "/results.h5").profile("velocity_x");
  ASSERT_EQ(profile.shape.back(), 16u);
  const double* last = profile.values.data() + profile.values.size() - 16;
  for (int k = 0; k < 16; ++k) {
    const double y = (k + 0.5) / 16;
    EXPECT_NEAR(last[k], 0.25 + 4 * y * (1 - y), GetParam().tolerance) << "cell " << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Run, FluidLaw,
    ::testing::Values(Choice{"TRT", {"lattice.collision=TRT"}, 1e-3}, Choice{"MRT", {"lattice.collision=MRT"}, 1e-3},
                      Choice{"BGK", {"lattice.collision=BGK"}, 8e-3},
                      Choice{"SinglePrecision", {"lattice.precision=float32"}, 1e-3},
                      Choice{"SinglePrecisionMRT", {"lattice.precision=float32", "lattice.collision=MRT"}, 1e-3},
                      Choice{"D3Q27", {"lattice.stencil=D3Q27"}, 1e-3},
                      Choice{"D3Q27MRT", {"lattice.stencil=D3Q27", "lattice.collision=MRT"}, 1e-3},
                      Choice{"FullWay", {"boundaries.y_low.law=full-way", "boundaries.y_high.law=full-way"}, 1e-3},
                      Choice{"ExactDifference", {"force.law=exact-difference"}, 1e-3},
                      Choice{"He", {"force.law=he"}, 1e-3},
                      Choice{"VelocityShift", {"force.law=velocity-shift", "lattice.collision=BGK"}, 8e-3}),
    [](const auto& test) { return std::string(test.param.name); });

/// The same solid as spheres, as raw voxels and as .npy, cell by cell.
TEST(FluidFiles, VoxelsAreTheSolidThatTheyDescribe) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel);
  const std::string solid = R"(solid.spheres=[[0.1,0.5,0.125,0.2]])", brief = "run.end_time=0.1";
  ASSERT_EQ(stresslet(run_arguments(input, place / "sphere", {solid, brief})).code, 0);
  const auto last = [&](const std::string& run) {
    const FieldFile file = field_headers(place / run, 1 << 30).back();
    return read_field_file((place / run) + "/fields/" + field_file_name(file.step));
  };
  const FieldFile expected = last("sphere");

  std::string voxels;
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 4; ++x) {
        const auto nearest = [](double d, double period) { return d - period * std::round(d / period); };
        const double dx = nearest((x + 0.5) / 16 - 0.1, 0.25), dy = (y + 0.5) / 16 - 0.5,
                     dz = nearest((z + 0.5) / 16 - 0.125, 0.25);
        voxels += char(dx * dx + dy * dy + dz * dz < 0.04);
      }
  std::string header = "{'descr': '|u1', 'fortran_order': False, 'shape': (4, 16, 4), }";
  header += std::string(128 - 10 - header.size() - 1, ' ') + "\n";
  const std::string npy = std::string("\x93NUMPY\x01\x00", 8) + char(header.size()) + char(0) + header + voxels;
  for (const auto& [name, content] : {std::pair{"mask.raw", voxels}, std::pair{"mask.npy", npy}}) {
    std::ofstream(place / name, std::ios::binary) << content;
    const Outcome run = stresslet(
        run_arguments(input, place / (std::string("of-") + name), {"solid.file=\"" + (place / name) + "\"", brief}));
    ASSERT_EQ(run.code, 0) << run.err;
    const FieldFile found = last(std::string("of-") + name);
    for (std::size_t k = 0; k < expected.fields.size(); ++k)
      EXPECT_EQ(found.fields[k].values, expected.fields[k].values) << name << " " << expected.fields[k].name;
  }
}

/// A run that starts from the fields of another goes on close to it: velocities and pressure are kept, the stress
/// relaxes within a few steps.
TEST(FluidFiles, AStartFromFieldsGoesOn) {
  const Workplace place;
  const std::string input = place.write("case.toml", channel);
  const auto profile = [&](const std::string& run) {
    const auto all = ResultsReader((place / run) + "/results.h5").profile("velocity_x");
    return std::vector<double>(all.values.end() - 16, all.values.end());
  };
  ASSERT_EQ(stresslet(run_arguments(input, place / "whole", {"run.end_time=4", "output.profile_every=4"})).code, 0);
  ASSERT_EQ(stresslet(run_arguments(input, place / "first",
                                    {"run.end_time=2", "output.fields_every=2", "output.profile_every=2"}))
                .code,
            0);
  const auto header = field_headers(place / "first", 1 << 30).back();
  const std::string fields = (place / "first") + "/fields/" + field_file_name(header.step);
  const Outcome second = stresslet(run_arguments(
      input, place / "second",
      {"run.end_time=2", "output.profile_every=2", "initial.velocity=[0,0,0]", "initial.file=\"" + fields + "\""}));
  ASSERT_EQ(second.code, 0) << second.err;
  const std::vector<double> whole = profile("whole"), found = profile("second"), half = profile("first");
  for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(found[k], whole[k], 2e-3) << "cell " << k;
  EXPECT_GT(whole[8] - half[8], 0.02) << "the flow still develops in between";
}

}  // namespace
}  // namespace stresslet
