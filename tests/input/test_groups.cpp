/// Keys that depend on each other: groups with too many or too few members, and values that contradict.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

#include "complaint_of.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// A valid input of nine lines; what a test adds starts on line 10.
const std::string base = R"(# A comment.
[suspension]
solid_fraction = 0.5

[run]
strain = 10



)";
const std::string without_solid_fraction = "[run]\nstrain = 10\n";
const std::string si = "[units]\ndiameter = 1e-4\nviscosity = 2.0\nshear_rate = 50.0\ndensity = 1000.0\n";

struct Conflict {
  const char* name;
  std::string text;
  std::vector<std::string> overrides;
  const char* where_and_problem;
  const char* reason;
  const char* fix;
};

std::ostream& operator<<(std::ostream& out, const Conflict& conflict) { return out << conflict.name; }

class Group : public ::testing::TestWithParam<Conflict> {};

TEST_P(Group, IsRefusedWithPlaceReasonAndFix) {
  const std::string message = complaint_of(GetParam().text, GetParam().overrides);
  EXPECT_THAT(message, StartsWith(GetParam().where_and_problem));
  EXPECT_THAT(message, HasSubstr(GetParam().reason));
  EXPECT_THAT(message, HasSubstr(std::string("\n  fix: ") + GetParam().fix));
}

INSTANTIATE_TEST_SUITE_P(
    Input, Group,
    ::testing::Values(
        Conflict{"NoPackingAtAll",
                 without_solid_fraction,
                 {},
                 "case.toml: suspension.solid_fraction is missing\n",
                 "its density has no default",
                 "add solid_fraction"},
        Conflict{"FileAndSolidFraction",
                 base,
                 {"suspension.file=start.csv"},
                 "case.toml:3: both suspension.file and suspension.solid_fraction are given\n",
                 "suspension.file is given at --set suspension.file=start.csv",
                 "remove one of them"},
        Conflict{"FileAndCount",
                 without_solid_fraction + "[suspension]\nfile = \"a.csv\"\ncount = 5\n",
                 {},
                 "case.toml:5: both suspension.file and suspension.count are given\n",
                 "suspension.file is given at case.toml:4",
                 "remove one of them, or override with --set suspension.file="},
        Conflict{"FileAndAspect",
                 without_solid_fraction + "[suspension]\nfile = \"a.csv\"\nbox_aspect = [1, 1, 2]\n",
                 {},
                 "case.toml:5: both suspension.file and suspension.box_aspect are given\n",
                 "already holds",
                 "remove"},
        Conflict{"FileAndSizes",
                 without_solid_fraction + "[suspension]\nfile = \"a.csv\"\n[suspension.sizes]\n",
                 {},
                 "case.toml:5: both suspension.file and suspension.sizes are given\n",
                 "already holds",
                 "remove"},
        Conflict{"BeyondDensestCrystal",
                 base + "[suspension.sizes]\nlaw = \"monodisperse\"\n",
                 {"suspension.solid_fraction=0.75"},
                 "--set suspension.solid_fraction=0.75: suspension.solid_fraction = 0.75 can never be reached\n",
                 "equal spheres fill at most 0.7405 of space",
                 "lower it"},
        Conflict{"BeyondDensestCrystalByAListOfOne",
                 base + "[suspension.sizes]\ndiameters = [1]\nnumber_shares = [1]\n",
                 {"suspension.solid_fraction=0.75"},
                 "--set suspension.solid_fraction=0.75: ",
                 "0.7405",
                 "lower it"},
        Conflict{"BeyondAnyPacking",
                 base,
                 {"suspension.solid_fraction=0.91"},
                 "--set suspension.solid_fraction=0.91: suspension.solid_fraction = 0.91 is out of reach\n",
                 "exceeds 0.9",
                 "lower it"},
        Conflict{"DiametersWithoutShares",
                 base + "[suspension.sizes]\ndiameters = [1, 2]\n",
                 {},
                 "case.toml:11: suspension.sizes.diameters is given without shares\n",
                 "how many particles each size has",
                 "add volume_shares = [...] or number_shares"},
        Conflict{"SharesWithoutDiameters",
                 base + "[suspension.sizes]\nnumber_shares = [0.5, 0.5]\n",
                 {},
                 "case.toml:11: suspension.sizes.number_shares is given without suspension.sizes.diameters\n",
                 "a share belongs to a diameter",
                 "add diameters"},
        Conflict{"BothShares",
                 base + "[suspension.sizes]\ndiameters = [1]\nvolume_shares = [1]\nnumber_shares = [1]\n",
                 {},
                 "case.toml:13: both suspension.sizes.volume_shares and suspension.sizes.number_shares are given\n",
                 "given at case.toml:12",
                 "remove one"},
        Conflict{"FewerSharesThanSizes",
                 base + "[suspension.sizes]\ndiameters = [1, 2]\nvolume_shares = [1]\n",
                 {},
                 "case.toml:12: suspension.sizes.volume_shares has 1 entries\n",
                 "diameters has 2",
                 "give both lists"},
        Conflict{"SharesBeyondOne",
                 base + "[suspension.sizes]\ndiameters = [1, 2]\nvolume_shares = [1, 1]\n",
                 {},
                 "case.toml:12: suspension.sizes.volume_shares adds up to 2\n",
                 "shares must add up to 1",
                 "for instance [0.5, 0.5]"},
        Conflict{"NoSizes",
                 base + "[suspension.sizes]\ndiameters = []\nvolume_shares = []\n",
                 {},
                 "case.toml:11: suspension.sizes.diameters is an empty list\n",
                 "at least one size",
                 "give a number > 0"},
        Conflict{"KeyOfAnotherSizeLaw",
                 base + "[suspension.sizes]\nlaw = \"monodisperse\"\nsigma = 0.1\n",
                 {},
                 "case.toml:12: suspension.sizes.sigma has no effect\n",
                 "it belongs to law = \"lognormal\", but the law is \"monodisperse\"",
                 "remove it, or write law"},
        Conflict{"LognormalWithoutSigma",
                 base + "[suspension.sizes]\nlaw = \"lognormal\"\nmedian_diameter = 1\nsmallest = 0.5\nlargest = 2\n",
                 {},
                 "case.toml:10: suspension.sizes.sigma is missing\n",
                 "law = \"lognormal\" needs it",
                 "add sigma = ..."},
        Conflict{"LognormalCutsExchanged",
                 base + "[suspension.sizes]\nlaw = \"lognormal\"\nmedian_diameter = 1\nsigma = 0.2\nsmallest = 2\n"
                        "largest = 0.5\n",
                 {},
                 "case.toml:14: suspension.sizes.smallest = 2 is not below largest = 0.5\n",
                 "case.toml:15",
                 "exchange"},
        Conflict{"TableWithoutFile",
                 base + "[suspension.sizes]\nlaw = \"table\"\nshares = \"number\"\n",
                 {},
                 "case.toml:10: suspension.sizes.file is missing\n",
                 "law = \"table\" needs it",
                 "add file = ..."},
        Conflict{"TableWithoutKindOfShares",
                 base + "[suspension.sizes]\nlaw = \"table\"\nfile = \"a.csv\"\n",
                 {},
                 "case.toml:10: suspension.sizes.shares is missing\n",
                 "law = \"table\" needs it",
                 "add shares = ..."},
        Conflict{"NameAndSwitch",
                 base + "[model]\nname = \"CLM\"\ndrag = false\n",
                 {},
                 "case.toml:12: both model.name and model.drag are given\n",
                 "model.name is given at case.toml:11",
                 "remove one of them, or override with --set model.name="},
        Conflict{"TwoOfThreeSwitches",
                 base + "[model]\nlubrication = \"normal\"\ndrag = false\n",
                 {},
                 "case.toml:10: model.stresslet is missing\n",
                 "the three switches",
                 "add it to [model]"},
        Conflict{"TwoStiffnesses",
                 base + "[contact]\nlargest_overlap = 0.01\nstiffness = 1e5\n",
                 {},
                 "case.toml:11: both contact.stiffness and contact.largest_overlap are given\n",
                 "contact.stiffness is given at case.toml:12",
                 "remove one"},
        Conflict{"TwoOtherStiffnesses",
                 base + "[contact]\nlargest_overlap = 0.01\nstiffness_si = 1e5\n" + si,
                 {},
                 "case.toml:11: both contact.stiffness_si and contact.largest_overlap are given\n",
                 "case.toml:12",
                 "remove one"},
        Conflict{"StiffnessInSiWithoutUnits",
                 base + "[contact]\nstiffness_si = 10\n",
                 {},
                 "case.toml:11: contact.stiffness_si is given without [units]\n",
                 "are needed to make it dimensionless",
                 "add [units]"},
        Conflict{"ThreeOfFourUnits",
                 base + "[units]\ndiameter = 1e-4\nviscosity = 1\nshear_rate = 1\n",
                 {},
                 "case.toml:10: units.density is missing\n",
                 "it has no default",
                 "add density = ... to [units]"},
        Conflict{"UnitsAndStokes",
                 base + "[flow]\nstokes = 0.1\n" + si,
                 {},
                 "case.toml:12: both flow.stokes and units are given\n",
                 "flow.stokes is given at case.toml:11",
                 "remove one of them, or override with --set flow.stokes="},
        Conflict{"UnitsThatOverflow",
                 base + si,
                 {"units.diameter=1e200"},
                 "case.toml:10: the Stokes number of [units] is not finite\n",
                 "overflows",
                 "check the powers of ten"},
        Conflict{"UnitsThatUnderflow",
                 base + si,
                 {"units.diameter=1e-200"},
                 "case.toml:10: the Stokes number of [units] is zero\n",
                 "underflows",
                 "check the powers of ten"},
        Conflict{"CutoffsExchanged",
                 base + "[lubrication]\nouter_cutoff = 0.001\ninner_cutoff = 0.05\n",
                 {},
                 "case.toml:12: lubrication.inner_cutoff = 0.05 is not below outer_cutoff = 0.001\n",
                 "case.toml:11",
                 "exchange or correct the two"},
        Conflict{"OuterCutoffBelowDefaultInner",
                 base + "[lubrication]\nouter_cutoff = 0.0001\n",
                 {},
                 "case.toml:10: lubrication.inner_cutoff = 0.001 is not below outer_cutoff = 0.0001\n",
                 "case.toml:11",
                 "exchange or correct"},
        Conflict{"InertialessWithoutDrag",
                 base + "[model]\nname = \"CLM-SS\"\n[time]\nscheme = \"inertialess\"\n",
                 {},
                 "case.toml:13: the inertialess scheme needs a model with Stokes drag\n",
                 "without Stokes drag the resistance is singular",
                 "choose a model with drag"},
        Conflict{"InertialessWithDragSwitchedOff",
                 base + "[model]\nlubrication = \"complete\"\ndrag = false\nstresslet = true\n",
                 {"time.scheme=inertialess"},
                 "--set time.scheme=inertialess: the inertialess scheme needs",
                 "the model is chosen at case.toml:12",
                 "choose a model with drag"},
        Conflict{"InertialessRebound",
                 base + "[contact]\nrestitution = 0.5\n",
                 {"time.scheme=inertialess"},
                 "case.toml:11: contact.restitution = 0.5 does not go with the inertialess scheme\n",
                 "without inertia nothing rebounds",
                 "remove it or give 1"},
        Conflict{"AverageBeyondTheEnd",
                 base,
                 {"run.average_from=10"},
                 "--set run.average_from=10: run.average_from = 10 is not below run.strain = 10\n",
                 "before the first mean is taken",
                 "lower it, or raise run.strain"},
        Conflict{"SampleBeyondTheEnd",
                 base,
                 {"output.sample_every=11"},
                 "--set output.sample_every=11: output.sample_every = 11 exceeds run.strain = 10\n",
                 "before the first sample",
                 "lower it, or raise run.strain"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(GroupsThatFit, AreAccepted) {
  EXPECT_THAT(complaint_of(base), IsEmpty());
  EXPECT_THAT(complaint_of(without_solid_fraction + "[suspension]\nfile = \"a.csv\"\n"), IsEmpty());
  EXPECT_THAT(complaint_of(base + si + "[contact]\nstiffness_si = 10\n"), IsEmpty());
  EXPECT_THAT(complaint_of(base + "[contact]\nlargest_overlap = 0.01\n"), IsEmpty());
  EXPECT_THAT(complaint_of(base + "[model]\nlubrication = \"none\"\ndrag = true\nstresslet = false\n"), IsEmpty());
  EXPECT_THAT(complaint_of(base, {"time.scheme=inertialess"}), IsEmpty());
  EXPECT_THAT(complaint_of(base, {"model.name=GRM", "flow.boundary=walls"}), IsEmpty());
  EXPECT_THAT(complaint_of(base + "[suspension.sizes]\nlaw = \"table\"\nfile = \"a.csv\"\nshares = \"volume\"\n"),
              IsEmpty());
  EXPECT_THAT(complaint_of(base + "[suspension.sizes]\ndiameters = [1, 2, 3]\nnumber_shares = [0.333, 0.333, 0.333]\n"),
              IsEmpty());
  EXPECT_THAT(complaint_of(base + "[suspension.sizes]\nlaw = \"lognormal\"\nmedian_diameter = 1\nsigma = 0.2\n"
                                  "smallest = 0.5\nlargest = 2\n"),
              IsEmpty());
}

}  // namespace
}  // namespace stresslet
