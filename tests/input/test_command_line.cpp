/// The command line: help, version, lists, new inputs, checks, and its own refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../program.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(CommandLine, HelpOfEverySubcommand) {
  const Outcome all = stresslet({"--help"});
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.out, HasSubstr("Exit codes: 0 finished, 2 wrong input, 3 numerical failure"));
  for (const char* command : {"new", "check", "run", "restart", "list", "validate"}) {
    EXPECT_THAT(all.out, HasSubstr(command));
    const Outcome help = stresslet({command, "--help"});
    EXPECT_EQ(help.code, 0) << command;
    EXPECT_GT(help.out.size(), 100u) << command;
    EXPECT_EQ(help.err, "") << command;
  }
}

TEST(CommandLine, VersionNamesTheBuild) {
  const Outcome outcome = stresslet({"--version"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, StartsWith("stresslet 0."));
  EXPECT_THAT(outcome.out, HasSubstr("commit"));
}

TEST(CommandLine, ListsLawsColumnsAndKeys) {
  const Outcome laws = stresslet({"list", "laws"});
  EXPECT_EQ(laws.code, 0);
  for (const char* name : {"NLM", "CLM", "NLM-S", "CLM-S", "CLM-SS", "GRM", "hooke", "hertz", "semi-implicit",
                           "explicit", "inertialess", "complete", "grand-resistance", "lognormal", "table"})
    EXPECT_THAT(laws.out, HasSubstr(name));
  EXPECT_EQ(stresslet({"list"}).out, laws.out);
  const Outcome columns = stresslet({"list", "columns"});
  EXPECT_THAT(columns.out, HasSubstr("relative_viscosity_from_dissipation"));
  EXPECT_THAT(columns.out, HasSubstr("lubrication_strain_yz"));
  const Outcome keys = stresslet({"list", "keys"});
  for (const char* key : {"solid_fraction", "inner_cutoff", "average_from", "monitor_tolerance"})
    EXPECT_THAT(keys.out, HasSubstr(key));
}

TEST(CommandLine, WrongArgumentsHaveExitCode2) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  const std::vector<std::vector<std::string>> wrong{{},
                                                    {"fly"},
                                                    {"run"},
                                                    {"run", input},
                                                    {"run", input, "--output"},
                                                    {"run", input, "--output", place / "results", "--fast"},
                                                    {"restart"},
                                                    {"check"},
                                                    {"new"},
                                                    {"list", "stars"},
                                                    {"validate"},
                                                    {"validate", "L99"}};
  for (const auto& arguments : wrong) {
    const Outcome outcome = stresslet(arguments);
    EXPECT_EQ(outcome.code, 2) << ::testing::PrintToString(arguments);
    EXPECT_GT(outcome.err.size(), 20u) << ::testing::PrintToString(arguments);
  }
  EXPECT_FALSE(std::filesystem::exists(place / "results"));
}

TEST(CommandLine, NewInputCanBeCheckedAndIsNotOverwritten) {
  const Workplace place;
  const std::string file = place / "new.toml";
  EXPECT_EQ(stresslet({"new", file}).code, 0);
  EXPECT_EQ(stresslet({"new", "-"}).out, content_of(file));
  EXPECT_EQ(stresslet({"check", file}).code, 0);

  std::ofstream(file) << small_case();
  const Outcome again = stresslet({"new", file});
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.err, HasSubstr("exists already"));
  EXPECT_EQ(content_of(file), small_case());

  const Outcome nowhere = stresslet({"new", place / "absent/new.toml"});
  EXPECT_EQ(nowhere.code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("fix: "));
}

TEST(CommandLine, CheckPrintsWhatFollowsFromTheInput) {
  const Workplace place;
  const Outcome outcome = stresslet({"check", place.write("case.toml", small_case())});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.err, "");
  for (const char* line : {"solid fraction", "0.45", "Stokes number", "half period of a contact", "bound by", "memory",
                           "expected time", "fewer than 500 particles"})
    EXPECT_THAT(outcome.out, HasSubstr(line));
  EXPECT_EQ(outcome.out.find("  \n"), std::string::npos) << "trailing blanks";
}

TEST(CommandLine, ResolvedInputReadsBackToItself) {
  const Workplace place;
  const Outcome once = stresslet({"check", place.write("case.toml", small_case()), "--resolved"});
  EXPECT_EQ(once.code, 0);
  EXPECT_THAT(once.out, HasSubstr("inner_cutoff = 0.001"));
  const Outcome twice = stresslet({"check", place.write("resolved.toml", once.out), "--resolved"});
  EXPECT_EQ(twice.code, 0) << twice.err;
  EXPECT_EQ(twice.out, once.out);
}

TEST(CommandLine, OverridesApplyInOrderAndCanRemoveKeys) {
  const Workplace place;
  const std::string input = place.write("case.toml", small_case());
  const Outcome outcome = stresslet({"check", input, "--resolved", "--set", "contact.friction=0.7", "--set",
                                     "contact.friction=0.9", "--set", "run.average_from="});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("friction = 0.9"));
  EXPECT_EQ(outcome.out.find("average_from = "), std::string::npos);
}

TEST(CommandLine, ValuesKeepACarriageReturn) {
  const Workplace place;
  const Outcome outcome = stresslet({"new", place / "case.toml"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Outcome wrong = stresslet({"check", place / "case.toml", "--set", "run.strain=1\r"});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("run.strain must be a number"));
}

TEST(CommandLine, CalibrationOfWallsTakesNoOptionOfPairs) {
  const Outcome outcome = stresslet({"calibrate", "--wall", "--gaps", "0.5"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--wall"), HasSubstr("--gaps")));
}

}  // namespace
}  // namespace stresslet
