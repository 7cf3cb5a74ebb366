/// Fluid cases that cannot be run: each with place, problem, reason and fix; and what is settled in those that can.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

#include "complaint_of.hpp"
#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/fluid/plan.hpp"
#include "stresslet/simulation/fluid/solid_mask.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;

/// A channel; line 5 is the end of [domain], line 8 of [flow], line 11 of [run].
constexpr const char* channel = R"(fidelity = "fluid"
[domain]
size = [1, 1]
resolution = 16

[flow]
reynolds = 10

[run]
end_time = 1

[boundaries.y_low]
[boundaries.y_high]
)";

FluidCase fluid_case(const std::vector<std::string>& overrides) {
  return std::get<FluidCase>(read_any_case_text(channel, "case.toml", overrides));
}

std::string fluid_complaint(const std::vector<std::string>& overrides) {
  return complaint_of([&] {
    const FluidCase settled = fluid_case(overrides);
    solid_mask(settled, make_plan(settled).setup.grid);
  });
}

struct WrongFluid {
  const char* name;
  std::vector<std::string> overrides;
  std::vector<const char*> parts;
};
std::ostream& operator<<(std::ostream& out, const WrongFluid& wrong) { return out << wrong.name; }

class FluidRefusal : public ::testing::TestWithParam<WrongFluid> {};

TEST_P(FluidRefusal, NamesPlaceProblemReasonAndFix) {
  const std::string message = fluid_complaint(GetParam().overrides);
  for (const char* part : GetParam().parts) EXPECT_THAT(message, HasSubstr(part));
  for (const char* part : {"\n  why: ", "\n  fix: "}) EXPECT_THAT(message, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(
    Input, FluidRefusal,
    ::testing::Values(
        WrongFluid{"UnknownFidelity", {"fidelity=fluids"}, {"fidelity knows no \"fluids\"", "did you mean \"fluid\"?"}},
        WrongFluid{"UnknownKey", {"flow.reynold=3"}, {"unknown key flow.reynold", "did you mean flow.reynolds?"}},
        WrongFluid{"KeyOfASuspension", {"suspension.count=3"}, {"unknown section [suspension]"}},
        WrongFluid{"OneDimension", {"domain.size=[1]"}, {"--set domain.size=[1]: domain.size has 1 entries"}},
        WrongFluid{
            "BrokenCells", {"domain.size=[1.03,1]"}, {"x = 1.03 L is 16.48 cells long", "nearest possible: 1 L"}},
        WrongFluid{"StencilOfOtherDimensions",
                   {"lattice.stencil=D3Q19"},
                   {"does not go with a domain of 2 dimensions", "case.toml:3"}},
        WrongFluid{"NoReynolds", {"flow.reynolds="}, {"flow.reynolds is missing"}},
        WrongFluid{"ReynoldsTwice",
                   {"units.length=1", "units.velocity=1", "units.kinematic_viscosity=1", "units.density=1"},
                   {"both flow.reynolds and units are given", "case.toml:7"}},
        WrongFluid{"UnitsUnderflow",
                   {"flow.reynolds=", "units.length=1e-300", "units.velocity=1e-300", "units.kinematic_viscosity=1",
                    "units.density=1"},
                   {"the Reynolds number of [units] is zero"}},
        WrongFluid{"MachAboveTheCap",
                   {"lattice.relaxation_time=1"},
                   {"the Mach number would be 0.18", "nearest possible: lattice.relaxation_time = 0.777"}},
        WrongFluid{"RelaxationTimeOfOneHalf",
                   {"lattice.relaxation_time=0.5"},
                   {"lattice.relaxation_time is out of range", "> 0.5"}},
        WrongFluid{"ReynoldsUnreachable",
                   {"flow.reynolds=1e6"},
                   {"cannot be reached with 16 cells", "or domain.resolution = 28868"}},
        WrongFluid{"GridTooLarge",
                   {"domain.resolution=100000", "domain.size=[1,1,1]"},
                   {"needs ", "GB of memory", "nearest possible: a resolution of about"}},
        WrongFluid{"BulkRateWithoutMrt", {"lattice.bulk_rate=1"}, {"lattice.bulk_rate has no effect"}},
        WrongFluid{"SinglePrecisionInThePlane", {"lattice.precision=float32"}, {"needs the stencil D3Q19"}},
        WrongFluid{"TooManyBlocks", {"lattice.blocks=[20,1,1]"}, {"20 blocks for 16 cells along x"}},
        WrongFluid{"ForceTwice",
                   {"force.density=[1,0,0]", "force.pressure_gradient=[1,0,0]"},
                   {"both force.density and force.pressure_gradient are given"}},
        WrongFluid{"NoForce", {"force.law=guo"}, {"[force] has neither density nor pressure_gradient"}},
        WrongFluid{"FrequencyTwice",
                   {"force.density=[1,0,0]", "force.womersley=1", "force.angular_frequency=1"},
                   {"both force.womersley and force.angular_frequency"}},
        WrongFluid{
            "OneFaceOnly", {"boundaries.x_low.law=half-way"}, {"boundaries.x_low is given without boundaries.x_high"}},
        WrongFluid{"ShearedAndWalls",
                   {"boundaries.shear_rate=1"},
                   {"both boundaries.shear_rate and faces across y are given"}},
        WrongFluid{"ShearedAndOpenAlongTheFlow",
                   {"boundaries.shear_rate=1", "boundaries.x_low.law=half-way", "boundaries.x_high.law=half-way"},
                   {"a sheared box must be periodic along x"}},
        WrongFluid{"WallThroughItself",
                   {"boundaries.y_low.velocity=[0,0.1,0]"},
                   {"the wall boundaries.y_low moves through itself", "would pump mass"}},
        WrongFluid{"PressureAtAWall", {"boundaries.y_low.pressure=1"}, {"boundaries.y_low.pressure has no effect"}},
        WrongFluid{"FacesAcrossZInThePlane",
                   {"boundaries.z_low.law=half-way", "boundaries.z_high.law=half-way"},
                   {"faces across z are given for a flow in the plane"}},
        WrongFluid{"WavesOfRest", {"initial.waves=[1,0,0]"}, {"initial.waves has no effect"}},
        WrongFluid{"FlatVortices",
                   {"initial.state=taylor-green", "initial.waves=[1,0,0]"},
                   {"need waves along x and along y"}},
        WrongFluid{"LinearWithoutWalls",
                   {"initial.state=linear", "boundaries.y_low=", "boundaries.y_high="},
                   {"a linear profile needs faces across y"}},
        WrongFluid{"NoBody", {"solid.cylinder_axis=z"}, {"[solid] names no body"}},
        WrongFluid{"SphereOfThreeNumbers",
                   {"solid.spheres=[[0.5,0.5,0.1]]"},
                   {"entry 1 of solid.spheres has 3 numbers", "4 are needed: x, y, z, radius"}},
        WrongFluid{"BodyFarAway", {"solid.cylinders=[[500,0.5,0.1]]"}, {"far outside the domain"}},
        WrongFluid{"NoFluidLeft", {"solid.cylinders=[[0.5,0.5,2]]"}, {"no cell is left to the fluid"}},
        WrongFluid{"NoVoxels", {"solid.file=/absent/voxels.raw"}, {"there is no such file"}},
        WrongFluid{
            "SamplesBeyondTheEnd", {"output.sample_every=2"}, {"output.sample_every = 2 exceeds run.end_time = 1"}},
        WrongFluid{
            "UnknownField", {"output.fields=[\"velocty\"]"}, {"output.fields knows no", "did you mean \"velocity\"?"}},
        WrongFluid{"ProbeOutside", {"output.probes=[[0.5,1.5]]"}, {"output.probes lies outside the domain: y = 1.5"}},
        WrongFluid{
            "ProbeOfThreeNumbers", {"output.probes=[[0.5,0.5,0.5]]"}, {"entry 1 of output.probes has 3 numbers"}},
        WrongFluid{"PartUpsideDown",
                   {"output.fields_from=[0.5,0.5]", "output.fields_to=[0.2,0.8]"},
                   {"output.fields_from lies above fields_to"}}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(FluidInput, MisspeltFidelityIsNoticed) {
  EXPECT_THAT(complaint_of([] { read_any_case_text("fidelty = \"fluid\"\n[run]\nstrain=1\n", "case.toml"); }),
              HasSubstr("case.toml:1: unknown key fidelty"));
}

TEST(FluidInput, AFluidCaseIsNoSuspension) {
  EXPECT_THAT(complaint_of(std::string(channel)), HasSubstr("no case of a suspension"));
}

TEST(FluidInput, ResolvedInputReadsBackToItself) {
  for (const std::vector<std::string>& overrides :
       {std::vector<std::string>{},
        {"solid.spheres=[[0.5,0.5,0,0.1],[0.2,0.2,0,0.1]]", "output.probes=[[0.1,0.1]]", "output.fields=[]"},
        {"boundaries.y_low=", "boundaries.y_high=", "boundaries.shear_rate=1", "initial.state=shear-wave"},
        {"force.density=[1,0,0]", "force.womersley=3", "lattice.blocks=[2,1,1]"}}) {
    const FluidCase once = fluid_case(overrides);
    const FluidCase twice = std::get<FluidCase>(read_any_case_text(resolved_toml(once), "resolved"));
    EXPECT_TRUE(once == twice) << resolved_toml(once);
  }
}

TEST(FluidInput, TheTemplateCanBeRun) {
  const FluidCase settled = std::get<FluidCase>(read_any_case_text(new_fluid_case_template(), "new.toml"));
  EXPECT_EQ(make_plan(settled).setup.grid.size, (Cells{4, 32, 1}));
}

/// A relaxation time outside 0.51 ... 3 is run, with a warning.
TEST(FluidInput, UnverifiedRelaxationTimesAreWarnedOf) {
  const auto report = [](const std::vector<std::string>& overrides) {
    const FluidCase settled = fluid_case(overrides);
    return plan_report(settled, make_plan(settled));
  };
  EXPECT_THAT(report({"lattice.relaxation_time=0.505"}), HasSubstr("warning: relaxation time below 0.51"));
  EXPECT_THAT(report({"lattice.relaxation_time=3.5", "flow.reynolds=0.1"}),
              HasSubstr("warning: relaxation time above 3"));
  EXPECT_EQ(report({}).find("warning"), std::string::npos);
  EXPECT_THAT(report({}), HasSubstr("Mach number"));
}

/// SI values and the dimensionless group say the same.
TEST(FluidInput, UnitsGiveTheReynoldsNumber) {
  const FluidCase si = fluid_case({"flow.reynolds=", "units.length=2e-3", "units.velocity=5e-3",
                                   "units.kinematic_viscosity=1e-6", "units.density=1000"});
  EXPECT_DOUBLE_EQ(si.reynolds_number(), 10);
  EXPECT_THAT(plan_report(si, make_plan(si)), HasSubstr("rho U^2 = 0.025 Pa"));
}

/// A sphere around a corner of a periodic box is whole: 8 cells around the corner, 24 more at distance sqrt(11)/2.
TEST(SolidMask, BodiesGoOnAcrossPeriodicFaces) {
  const FluidCase settled = fluid_case({"domain.size=[1,1,1]", "domain.resolution=8",
                                        "boundaries.y_low=", "boundaries.y_high=", "solid.spheres=[[0,0,0,0.21]]"});
  const std::vector<std::uint8_t> mask = solid_mask(settled, make_plan(settled).setup.grid);
  EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 32);
  EXPECT_EQ(mask[0], 1);
  EXPECT_EQ(mask.back(), 1);
  EXPECT_EQ(mask[4], 0);
}

TEST(SolidMask, BodiesEndAtWalls) {
  const FluidCase settled = fluid_case({"domain.resolution=8", "solid.boxes=[[0,-0.25,0,1,0.25,1]]"});
  const std::vector<std::uint8_t> mask = solid_mask(settled, make_plan(settled).setup.grid);
  EXPECT_EQ(std::count(mask.begin(), mask.end(), 1), 16);
}

}  // namespace
}  // namespace stresslet
