/// What a case holds after reading: defaults, derived numbers, resolved input, template, example.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "complaint_of.hpp"
#include "stresslet/simulation/any_case.hpp"
#include "stresslet/simulation/plan.hpp"

namespace stresslet {
namespace {

const std::string smallest_input = "[suspension]\nsolid_fraction = 0.5\n[run]\nstrain = 10\n";
const std::filesystem::path example =
    std::filesystem::path(STRESSLET_SOURCE_DIR) / "examples" / "shear-lubricated" / "case.toml";

TEST(ReadCase, FillsInTheDocumentedDefaults) {
  const Case read = read_case_text(smallest_input, "case.toml");
  EXPECT_EQ(read.suspension.count, 1000);
  EXPECT_EQ(read.suspension.seed, 1);
  EXPECT_EQ(read.suspension.box_aspect, (Vec3<double>{1, 1, 1}));
  EXPECT_EQ(read.suspension.sizes->law, SizeLaw::discrete);
  EXPECT_EQ(read.suspension.sizes->diameters, (std::vector<double>{1.0, 1.4}));
  EXPECT_EQ(read.suspension.sizes->volume_shares, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(read.flow.boundary, BoxKind::lees_edwards);
  EXPECT_EQ(read.stokes_number(), 0.1);
  EXPECT_EQ(read.switches(), (ModelSwitches{"complete", true, true}));
  EXPECT_EQ(read.contact.normal, "hooke");
  EXPECT_EQ(read.contact_stiffness(), 2.5e5);
  EXPECT_EQ(read_case_text(smallest_input, "case.toml", {"contact.normal=hertz"}).contact_stiffness(), 1e7);
  EXPECT_EQ(read.contact.friction, 0);
  EXPECT_EQ(read.contact.tangential_ratio, 2.0 / 7.0);
  EXPECT_EQ(read.contact.restitution, 1);
  EXPECT_EQ(read.lubrication.inner_cutoff, 0.001);
  EXPECT_EQ(read.lubrication.outer_cutoff, 0.05);
  EXPECT_EQ(read.time.scheme, "semi-implicit");
  EXPECT_FALSE(read.time.step);
  EXPECT_FALSE(read.run.average_from);
  EXPECT_EQ(read.run.threads, 0);
  EXPECT_EQ(read.output.sample_every, 0.001);
  EXPECT_EQ(
      std::get<Case>(read_any_case_text(std::string("fidelity = \"resolved\"\n") + smallest_input, "case.toml", {}))
          .output.sample_every,
      0.01);
  EXPECT_TRUE(read.output.csv && read.output.xyz && read.output.paraview);
}

/// One key changes the fidelity of the same file.
TEST(ReadCase, WhatOnlyTheResolvedFluidNeedsMayStay) {
  const std::string text =
      std::string("fidelity = \"resolved\"\n") + smallest_input + "[resolution]\ncells_per_diameter = 8\n";
  const Case lubricated = std::get<Case>(read_any_case_text(text, "case.toml", {"fidelity=lubricated"}));
  EXPECT_FALSE(lubricated.resolved());
  EXPECT_EQ(lubricated.output.sample_every, 0.001);
  EXPECT_THAT(plan_report(lubricated, make_plan(lubricated)),
              testing::HasSubstr("resolution and flow.reynolds have no effect"));
}

TEST(ReadCase, ModelNamesMeanWhatTheThesisSays) {
  const auto switches = [](const std::string& name) {
    return read_case_text(smallest_input, "case.toml", {"model.name=" + name}).switches();
  };
  EXPECT_EQ(switches("NLM"), (ModelSwitches{"normal", false, false}));
  EXPECT_EQ(switches("CLM"), (ModelSwitches{"complete", false, false}));
  EXPECT_EQ(switches("NLM-S"), (ModelSwitches{"normal", true, true}));
  EXPECT_EQ(switches("CLM-S"), (ModelSwitches{"complete", true, true}));
  EXPECT_EQ(switches("CLM-SS"), (ModelSwitches{"complete", false, true}));
  EXPECT_EQ(switches("GRM"), (ModelSwitches{"grand-resistance", true, true}));
}

TEST(ReadCase, ModelLawsAreChoicesOfTheSwitch) {
  const auto known = lubrication_law_names();
  for (const NamedModel& model : named_models)
    EXPECT_THAT(known, ::testing::Contains(std::string(model.switches.lubrication)));
}

TEST(ReadCase, UnitsGiveStokesNumberAndStiffness) {
  const std::string si = "[units]\ndiameter = 2e-4\nviscosity = 0.5\nshear_rate = 100\ndensity = 1250\n";
  const Case hooke = read_case_text(smallest_input + si + "[contact]\nstiffness_si = 250\n", "case.toml");
  EXPECT_NEAR(hooke.stokes_number(), 1250 * 4e-8 * 100 / 0.5, 1e-15);
  EXPECT_NEAR(hooke.contact_stiffness().value(), 250 / (0.5 * 100 * 2e-4), 1e-9);
  const Case hertz =
      read_case_text(smallest_input + si + "[contact]\nnormal = \"hertz\"\nstiffness_si = 1e9\n", "case.toml");
  EXPECT_NEAR(hertz.contact_stiffness().value(), 1e9 / (0.5 * 100), 1e-5);
}

TEST(ReadCase, StiffnessFromAnOverlapIsLeftToBeDerived) {
  EXPECT_EQ(read_case_text(smallest_input, "case.toml", {"contact.largest_overlap=0.01"}).contact_stiffness(),
            std::nullopt);
}

TEST(ReadCase, WholeNumbersMayBeWrittenWithAnExponent) {
  EXPECT_EQ(read_case_text(smallest_input, "case.toml", {"suspension.count=1e4"}).suspension.count, 10000);
}

TEST(ReadCase, RelativeFileNamesStartFromTheInputOrTheWorkingDirectory) {
  const std::string text = "[run]\nstrain = 1\n[suspension]\nfile = \"packings/../start.csv\"\n";
  EXPECT_EQ(read_case_text(text, "case.toml", {}, "/data/cases").suspension.file->text, "/data/cases/start.csv");
  const Case overridden = read_case_text(text, "case.toml", {"suspension.file=start.csv"}, "/data/cases");
  EXPECT_EQ(overridden.suspension.file->text, (std::filesystem::current_path() / "start.csv").string());
}

TEST(ReadCase, LaterMessagesFindThePlaceOfAKey) {
  const Case read = read_case_text(smallest_input, "case.toml", {"contact.friction=1"});
  EXPECT_EQ(read.where("suspension.solid_fraction"), "case.toml:2");
  EXPECT_EQ(read.where("suspension.sizes.diameters"), "case.toml:1");
  EXPECT_EQ(read.where("contact.friction"), "--set contact.friction=1");
  EXPECT_EQ(read.where("time.step"), "case.toml");
}

TEST(ReadCase, EmptyOverrideRemovesAKey) {
  const Case read = read_case(example, {"model.name=", "model.lubrication=normal", "model.drag=true",
                                        "model.stresslet=false", "contact.stiffness=", "contact.largest_overlap=0.02"});
  EXPECT_EQ(read.switches(), (ModelSwitches{"normal", true, false}));
  EXPECT_EQ(read.contact.largest_overlap, 0.02);
}

TEST(ReadCase, PresetGivesWhatIsLeftOut) {
  const auto resolution = [](const std::string& keys) {
    const std::string text = std::string("fidelity = \"resolved\"\n") + smallest_input + "[resolution]\n" + keys;
    return *std::get<Case>(read_any_case_text(text, "case.toml", {})).resolution;
  };
  EXPECT_EQ(resolution("").cells_per_diameter, 10);
  EXPECT_EQ(resolution("preset = \"fast\"\n").cells_per_diameter, 8);
  EXPECT_EQ(resolution("preset = \"fast\"\n").relaxation_time, 2);
  EXPECT_EQ(resolution("preset = \"fast\"\ncells_per_diameter = 12\n").cells_per_diameter, 12);
}

class ResolvedInput : public ::testing::TestWithParam<std::vector<std::string>> {};

TEST_P(ResolvedInput, ReadsBackToAnEqualCase) {
  const Case read = read_case_text("[run]\nstrain = 12.345678901234567\n", "case.toml", GetParam());
  const std::string resolved = resolved_toml(read);
  EXPECT_TRUE(read_case_text(resolved, "resolved.toml") == read) << resolved;
  EXPECT_EQ(resolved_toml(read_case_text(resolved, "resolved.toml")), resolved);
}

INSTANTIATE_TEST_SUITE_P(
    Input, ResolvedInput,
    ::testing::Values(std::vector<std::string>{"suspension.solid_fraction=0.1", "time.step=1e-7", "output.csv=false"},
                      std::vector<std::string>{"suspension.file=/start \"1\"\\é\u0001.csv", "flow.boundary=walls"},
                      std::vector<std::string>{"suspension.solid_fraction=0.5", "model.lubrication=none",
                                               "model.drag=true", "model.stresslet=true", "time.scheme=inertialess",
                                               "contact.coulomb_limit=spring-dashpot"},
                      std::vector<std::string>{"suspension.solid_fraction=0.5",
                                               "units={diameter=1e-5,viscosity=3,shear_rate=7,density=1e3}",
                                               "contact.stiffness_si=12.3", "contact.friction=0.3333333333333333"},
                      std::vector<std::string>{"suspension.solid_fraction=0.5", "suspension.sizes.law=table",
                                               "suspension.sizes.file=/sizes.csv", "suspension.sizes.shares=number"},
                      std::vector<std::string>{"suspension.solid_fraction=0.5", "suspension.sizes.law=lognormal",
                                               "suspension.sizes.median_diameter=1.1", "suspension.sizes.sigma=0.2",
                                               "suspension.sizes.smallest=0.5", "suspension.sizes.largest=2",
                                               "suspension.seed=9223372036854775807",
                                               "suspension.box_aspect=[2, 1, 0.5]"},
                      std::vector<std::string>{"suspension.solid_fraction=0.5", "suspension.sizes.law=monodisperse",
                                               "contact.largest_overlap=0.01", "run.relative_error=0.01",
                                               "run.average_from=3"}));

TEST(ResolvedInput, DiffersWhereTheCaseDiffers) {
  EXPECT_FALSE(read_case_text(smallest_input, "case.toml") ==
               read_case_text(smallest_input, "case.toml", {"output.xyz=false"}));
}

TEST(NewCase, IsTheStandardCase) {
  const Case from_template = read_case_text(new_case_template(), "new.toml");
  EXPECT_EQ(from_template.suspension.solid_fraction, 0.5);
  EXPECT_EQ(from_template.run.strain, 10);
  EXPECT_TRUE(from_template == read_case(example));
}

TEST(NewCase, ResolvedReadsAsResolved) {
  const Case resolved = read_case_text(new_case_template(Fidelity::resolved), "new.toml");
  EXPECT_TRUE(resolved.resolved());
  // Without the fluid, the standard case of as many particles.
  const Case lubricated = read_case_text(new_case_template(), "new.toml", {"suspension.count=300"});
  EXPECT_EQ(resolved.suspension, lubricated.suspension);
  EXPECT_EQ(resolved.contact, lubricated.contact);
  EXPECT_EQ(resolved.flow.reynolds, resolved.stokes_number());
}

TEST(Example, GivesEveryKeyThatScriptsOverride) {
  const Case read =
      read_case(example, {"suspension.solid_fraction=0.45", "suspension.count=500", "suspension.seed=3",
                          "contact.friction=1.0", "model.name=\"NLM\"", "flow.stokes=0.05", "contact.stiffness=1e5",
                          "lubrication.inner_cutoff=0.002", "lubrication.outer_cutoff=0.1", "run.strain=5.0",
                          "run.average_from=2.0", "run.threads=2", "time.scheme=\"explicit\"", "time.step=2e-05"});
  EXPECT_EQ(read.suspension.solid_fraction, 0.45);
  EXPECT_EQ(read.suspension.count, 500);
  EXPECT_EQ(read.suspension.seed, 3);
  EXPECT_EQ(read.contact.friction, 1);
  EXPECT_EQ(read.switches(), (ModelSwitches{"normal", false, false}));
  EXPECT_EQ(read.stokes_number(), 0.05);
  EXPECT_EQ(read.contact_stiffness(), 1e5);
  EXPECT_EQ(read.lubrication.inner_cutoff, 0.002);
  EXPECT_EQ(read.lubrication.outer_cutoff, 0.1);
  EXPECT_EQ(read.run.strain, 5);
  EXPECT_EQ(read.run.average_from, 2);
  EXPECT_EQ(read.run.threads, 2);
  EXPECT_EQ(read.time.scheme, "explicit");
  EXPECT_EQ(read.time.step, 2e-5);
}

}  // namespace
}  // namespace stresslet
