/// Wrong input from the outside: the program ends with exit code 2 before it runs anything, says place, problem, reason
/// and fix on standard error, and leaves no results behind.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../program.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using Assignments = std::vector<std::string>;

/// Exit code 2 and the four parts of a message, starting with `where`.
void expect_refused(const Outcome& outcome, const std::string& where, const std::string& problem) {
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, StartsWith("stresslet: " + where));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr(problem), HasSubstr("\n  why: "), HasSubstr("\n  fix: ")));
  EXPECT_THAT(outcome.err, AllOf(Not(HasSubstr("terminate")), Not(HasSubstr("Sanitizer")), Not(HasSubstr("::"))));
}

struct Wrong {
  const char* name;
  Assignments assignments;
  const char* where;
  const char* problem;
};
std::ostream& operator<<(std::ostream& out, const Wrong& wrong) { return out << wrong.name; }

class Refusal : public ::testing::TestWithParam<Wrong> {};

TEST_P(Refusal, OfARun) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  expect_refused(stresslet(run_arguments(input, place / "results", GetParam().assignments)), GetParam().where,
                 GetParam().problem);
  EXPECT_FALSE(std::filesystem::exists(place / "results/results.h5"));
}

TEST_P(Refusal, OfACheck) {
  const Workplace place;
  std::vector<std::string> arguments{"check", place.write("case.toml", small_case())};
  for (const std::string& argument : settings(GetParam().assignments)) arguments.push_back(argument);
  expect_refused(stresslet(arguments), GetParam().where, GetParam().problem);
}

INSTANTIATE_TEST_SUITE_P(
    Input, Refusal,
    ::testing::Values(
        Wrong{"UnknownKey", {"suspension.solid_fractoin=0.4"}, "--set", "unknown key suspension.solid_fractoin"},
        Wrong{"WrongType", {"contact.friction=\"much\""}, "--set", "contact.friction must be a number"},
        Wrong{"NotAnAssignment", {"contact.friction"}, "--set contact.friction", "this is no assignment"},
        Wrong{"MissingGroup", {"suspension.solid_fraction="}, "", "suspension.solid_fraction is missing"},
        Wrong{"OverdeterminedStiffness",
              {"contact.stiffness=1e5", "contact.largest_overlap=0.01"},
              "--set",
              "both contact.stiffness and contact.largest_overlap"},
        Wrong{"OverdeterminedStart", {"suspension.file=\"start.csv\""}, "", "both suspension.file and"},
        Wrong{"SolidFractionOutOfReach",
              {"suspension.solid_fraction=0.8"},
              "--set suspension.solid_fraction=0.8",
              "solid fraction 0.8 is out of reach"},
        Wrong{"SolidFractionAboveOne", {"suspension.solid_fraction=1.5"}, "--set", "out of range"},
        Wrong{"NegativeSize",
              {"suspension.sizes.diameters=[1, -1.4]", "suspension.sizes.volume_shares=[0.5, 0.5]"},
              "--set",
              "suspension.sizes.diameters is out of range"},
        Wrong{"ZeroSize",
              {"suspension.sizes.diameters=[0.0]", "suspension.sizes.volume_shares=[1.0]"},
              "--set",
              "suspension.sizes.diameters is out of range"},
        Wrong{"ExplicitStepAboveTheLimit",
              {"time.scheme=explicit", "time.step=2e-5"},
              "--set time.step=2e-5",
              "above the largest step"},
        Wrong{"SemiImplicitStepAboveTheLimit", {"time.step=1e-3"}, "--set time.step=1e-3", "above the largest step"},
        Wrong{"NegativeStep", {"time.step=-1e-5"}, "--set", "time.step is out of range"},
        Wrong{"CutoffsInTheWrongOrder",
              {"lubrication.inner_cutoff=0.1"},
              "--set lubrication.inner_cutoff=0.1",
              "is not below outer_cutoff"},
        Wrong{"NotANumber", {"contact.friction=nan"}, "--set contact.friction=nan", "not a finite number"},
        Wrong{"Infinite", {"run.strain=inf"}, "--set run.strain=inf", "not a finite number"},
        Wrong{"BoxTooSmall", {"suspension.count=2"}, "--set suspension.count=2", "in its shortest periodic direction"},
        Wrong{"UnknownModel", {"model.name=\"CLMS\""}, "--set", "model.name knows no \"CLMS\""},
        Wrong{"InertialessWithoutDrag", {"time.scheme=inertialess", "model.name=CLM"}, "--set", "inertialess"},
        Wrong{"AveragesAfterTheEnd", {"run.average_from=3"}, "--set run.average_from=3", "is not below run.strain"},
        Wrong{"WeightThatTheOperatorDoesNotBear",
              {"fidelity=resolved", "resolution.coupling=bounce-back", "resolution.solid_weight=viscosity-scaled"},
              "--set resolution.solid_weight=viscosity-scaled",
              "does not bear the weight viscosity-scaled"},
        Wrong{"WallsWithFarLubrication",
              {"flow.boundary=walls", "lubrication.outer_cutoff=0.6"},
              "--set lubrication.outer_cutoff=0.6",
              "must be below 0.5 with walls"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Refusal, UnknownKeyNamesTheNearestAndItsLine) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case() + "[time]\nschem = \"explicit\"\n");
  const Outcome outcome = stresslet(run_arguments(input, place / "results"));
  expect_refused(outcome, input + ":15: ", "unknown key time.schem");
  EXPECT_THAT(outcome.err, HasSubstr("did you mean time.scheme?"));
}

TEST(Refusal, SolidFractionOutOfReachNamesItsLine) {
  const Workplace place;
  std::string text = small_case();
  text.replace(text.find("0.45"), 4, "0.75");
  const std::string input = place.write("case.toml", text);
  expect_refused(stresslet(run_arguments(input, place / "results")), input + ":2: ", "out of reach");
}

TEST(Refusal, MissingInput) {
  const Workplace place;
  const std::string absent = place / "absent.toml";
  expect_refused(stresslet(run_arguments(absent, place / "results")), absent, "cannot be opened");
  expect_refused(stresslet({"check", absent}), absent, "cannot be opened");
}

TEST(Refusal, OutputBelowAFile) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  expect_refused(stresslet(run_arguments(input, input + "/results")), input + "/results", "cannot be made");
  expect_refused(stresslet(run_arguments(input, input)), input, "cannot be made");
}

/// The kernel's own file system takes no folders, not even from root.
TEST(Refusal, OutputWhereNobodyMayWrite) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  expect_refused(stresslet(run_arguments(input, "/proc/results")), "/proc/results", "cannot be made");
}

TEST(Refusal, OutputThatMayNotBeWritten) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  std::filesystem::create_directory(place / "locked");
  std::filesystem::permissions(place / "locked", std::filesystem::perms::owner_read);
  expect_refused(stresslet(run_arguments(input, place / "locked")), place / "locked", "cannot be written");
}

/// A folder with a finished run.
class RefusalBesideResults : public ::testing::Test {
 protected:
  RefusalBesideResults() { EXPECT_EQ(stresslet(run_arguments(input_, results_)).code, 0); }

  std::string results(const std::string& name) const { return results_ + "/" + name; }

  Workplace place_;
  std::string input_ = place_.write("case.toml", small_case());
  std::string results_ = place_ / "results";
};

TEST_F(RefusalBesideResults, ExistingResultsAreKept) {
  std::vector<std::string> before;
  const std::vector<std::string> files{"results.h5", "series.csv", "particles.xyz", "particles.xdmf", "summary.json"};
  for (const std::string& file : files) before.push_back(content_of(results(file)));
  const Outcome outcome = stresslet(run_arguments(input_, results_, {"suspension.seed=5"}));
  expect_refused(outcome, results_, "holds results already");
  EXPECT_THAT(outcome.err, HasSubstr("--force"));
  for (std::size_t k = 0; k < files.size(); ++k) EXPECT_TRUE(content_of(results(files[k])) == before[k]) << files[k];
}

TEST_F(RefusalBesideResults, ForceWithWrongInputKeepsThemToo) {
  const std::string before = content_of(results("results.h5"));
  std::vector<std::string> arguments = run_arguments(input_, results_, {"suspension.solid_fraction=0.8"});
  arguments.push_back("--force");
  expect_refused(stresslet(arguments), "--set", "out of reach");
  EXPECT_TRUE(content_of(results("results.h5")) == before);
}

TEST_F(RefusalBesideResults, RestartOfAFinishedRun) {
  expect_refused(stresslet(restart_arguments(results_)), results_, "has reached strain 0.02");
}

TEST_F(RefusalBesideResults, RestartWithOtherPhysics) {
  const std::string before = content_of(results("results.h5"));
  for (const char* assignment : {"contact.friction=1", "time.step=1e-5", "suspension.seed=2", "output.sample_every=1"})
    expect_refused(stresslet(restart_arguments(results_, {"run.strain=1", assignment})),
                   std::string("--set ") + assignment, "cannot be changed by a restart");
  EXPECT_TRUE(content_of(results("results.h5")) == before);
}

TEST_F(RefusalBesideResults, RestartWithAWrongValue) {
  for (const char* assignment : {"run.strain=-1", "run.strain=nan", "run.strain=\"far\"", "run.stran=3"})
    expect_refused(stresslet(restart_arguments(results_, {assignment})), "--set", "run.str");
}

TEST_F(RefusalBesideResults, RestartOfADamagedFile) {
  const std::string whole = content_of(results("results.h5"));
  for (const std::size_t size :
       {std::size_t(0), std::size_t(5), std::size_t(100), whole.size() / 2, whole.size() - 1}) {
    std::ofstream(results("results.h5"), std::ios::binary) << whole.substr(0, size);
    expect_refused(stresslet(restart_arguments(results_, {"run.strain=0.1"})), results("results.h5"), "");
  }
}

TEST_F(RefusalBesideResults, RestartOfAFileWithOverwrittenBytes) {
  const std::string whole = content_of(results("results.h5"));
  for (std::size_t place = 8; place < whole.size(); place += whole.size() / 12) {
    std::string damaged = whole;
    for (std::size_t k = place; k < std::min(place + 600, whole.size()); ++k) damaged[k] = char(0xff);
    std::ofstream(results("results.h5"), std::ios::binary) << damaged;
    expect_refused(stresslet(restart_arguments(results_, {"run.strain=0.021"})), results("results.h5"), "damaged");
  }
}

TEST_F(RefusalBesideResults, RestartOfAForeignFile) {
  std::ofstream(results("results.h5")) << "strain,viscosity\n0,1\n";
  expect_refused(stresslet(restart_arguments(results_, {"run.strain=0.1"})), results("results.h5"),
                 "this is not a results file");
}

TEST_F(RefusalBesideResults, RestartOfNothing) {
  expect_refused(stresslet(restart_arguments(place_ / "absent")), place_ / "absent", "there is no such results file");
}

/// Start files: ten particles on a line, one line of it replaced.
class RefusalOfAStart : public ::testing::Test {
 protected:
  Outcome run_with(const std::string& name, const std::string& text, const std::string& box = "[20, 5, 5]") {
    file_ = place_.write(name, text);
    return stresslet(run_arguments(place_.write("case.toml", small_case()), place_ / "results",
                                   {"suspension.solid_fraction=", "suspension.count=", "suspension.seed=",
                                    "suspension.file=\"" + file_ + "\"", "suspension.box=" + box}));
  }

  static std::string csv(const std::string& second_row) {
    std::string text = "x,y,z,radius\n1,2,2,0.5\n" + second_row + "\n";
    for (int k = 2; k < 10; ++k) text += std::to_string(1 + 1.5 * k) + ",2,2,0.5\n";
    return text;
  }

  Workplace place_;
  std::string file_;
};

TEST_F(RefusalOfAStart, WrongNumbers) {
  EXPECT_EQ(run_with("start.csv", csv("2.5,2,2,0.5")).code, 0);
  std::filesystem::remove_all(place_ / "results");
  const Outcome not_a_number = run_with("start.csv", csv("nan,2,2,0.5"));
  expect_refused(not_a_number, file_ + ":3: ", "'nan' in column 'x'");
  const Outcome negative = run_with("start.csv", csv("2.5,2,2,-0.5"));
  expect_refused(negative, file_, "radius");
  const Outcome text = run_with("start.csv", csv("2.5,two,2,0.5"));
  expect_refused(text, file_ + ":3: ", "'two' in column 'y'");
  const Outcome overlap = run_with("start.csv", csv("1.5,2,2,0.5"));
  expect_refused(overlap, file_, "overlap");
  EXPECT_FALSE(std::filesystem::exists(place_ / "results/results.h5"));
}

TEST_F(RefusalOfAStart, WrongFiles) {
  const Outcome no_columns = run_with("start.csv", "a,b\n1,2\n");
  expect_refused(no_columns, file_, "x");
  const Outcome empty = run_with("start.csv", "");
  expect_refused(empty, file_, "");
  const Outcome no_frame = run_with("start.xyz", "no number\n");
  expect_refused(no_frame, file_ + ":1: ", "");
  const Outcome cut = run_with("start.xyz", "3\nProperties=pos:R:3:radius:R:1\n1 2 2 0.5\n");
  expect_refused(cut, file_, "");
  const Outcome not_a_number = run_with("start.xyz", "2\nProperties=pos:R:3:radius:R:1\n1 2 2 0.5\n4 nan 2 0.5\n");
  expect_refused(not_a_number, file_ + ":4: ", "nan");
}

TEST_F(RefusalOfAStart, WrongBox) {
  expect_refused(run_with("start.csv", csv("2.5,2,2,0.5"), "[20, 5]"), "--set suspension.box", "three numbers");
  expect_refused(run_with("start.csv", csv("2.5,2,2,0.5"), "[20, -5, 5]"), "--set suspension.box", "out of range");
  expect_refused(run_with("start.csv", csv("2.5,2,2,0.5"), "[20, 5, 1]"), "", "shortest periodic direction");
  const Outcome absent = stresslet(run_arguments(
      place_.write("case.toml", small_case()), place_ / "results",
      {"suspension.solid_fraction=", "suspension.count=", "suspension.seed=", "suspension.file=\"absent.xyz\""}));
  expect_refused(absent, "", "absent.xyz");
}

}  // namespace
}  // namespace stresslet
