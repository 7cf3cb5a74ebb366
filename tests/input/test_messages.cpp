/// Every way in which a single key can be wrong, and the message it gets: place, problem, reason, fix.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <ostream>

#include "complaint_of.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

struct WrongInput {
  const char* name;
  const char* text;
  const char* where_and_problem;  ///< start of the message
  const char* reason;
  const char* fix;
};

std::ostream& operator<<(std::ostream& out, const WrongInput& input) { return out << input.name; }

class Message : public ::testing::TestWithParam<WrongInput> {};

TEST_P(Message, NamesPlaceProblemReasonAndFix) {
  const std::string message = complaint_of(GetParam().text);
  EXPECT_THAT(message, StartsWith(GetParam().where_and_problem));
  EXPECT_THAT(message, HasSubstr(std::string("\n  why: ") + GetParam().reason));
  EXPECT_THAT(message, HasSubstr(std::string("\n  fix: ") + GetParam().fix));
}

INSTANTIATE_TEST_SUITE_P(
    Input, Message,
    ::testing::Values(
        WrongInput{"Syntax", "[suspension]\nsolid_fraction == 0.5\n",
                   "case.toml:2: this is not TOML: ", "reading stopped in column 17", "correct the line"},
        WrongInput{"DuplicateKey", "[run]\nstrain = 1\nstrain = 2\n",
                   "case.toml:3: this is not TOML: ", "reading stopped", "correct the line"},
        WrongInput{"NotUtf8", "[run]\nstrain = \"\xc3\x28\"\n", "case.toml:2: this is not TOML: ", "reading stopped",
                   "correct the line"},
        WrongInput{"MisspeltKey", "[suspension]\n\nsolid_fractoin = 0.5\n",
                   "case.toml:3: unknown key suspension.solid_fractoin\n", "a key that nothing reads is refused",
                   "did you mean suspension.solid_fraction?"},
        WrongInput{"KeyOfAnotherSection", "[model]\nfriction = 0.5\n", "case.toml:2: unknown key model.friction\n",
                   "a key that nothing reads", "friction belongs to section [contact]: move it there"},
        WrongInput{"KeyWithoutSection", "solid_fraction = 0.5\n", "case.toml:1: unknown key solid_fraction\n",
                   "a key that nothing reads", "solid_fraction belongs to section [suspension]: move it there"},
        WrongInput{"KeyLikeNothing", "[time]\nxylophone = 0.5\n", "case.toml:2: unknown key time.xylophone\n",
                   "a key that nothing reads", "keys of [time]: scheme, step"},
        WrongInput{"NothingLikeAKey", "xylophone = 0.5\n", "case.toml:1: unknown key xylophone\n",
                   "a key that nothing reads", "every key belongs to a section: suspension, suspension.sizes, flow"},
        WrongInput{"MisspeltSection", "[supension]\nsolid_fraction = 0.5\n",
                   "case.toml:1: unknown section [supension]\n", "known sections: suspension, ",
                   "did you mean [suspension]?"},
        WrongInput{"SectionLikeNothing", "[lattice]\n", "case.toml:1: unknown section [lattice]\n",
                   "known sections: suspension, ", "remove it, or correct its name"},
        WrongInput{"KeyAsSection", "[contact.friction]\nstatic = 1\n",
                   "case.toml:1: contact.friction must be a number\n", "found a section", "give a number, >= 0"},
        WrongInput{"SectionAsKey", "model = \"CLM-S\"\n", "case.toml:1: model must be a section\n",
                   "found the text \"CLM-S\"", "write [model] on a line of its own"},
        WrongInput{"QuotedKey", "[run]\n\"str.ain\" = 1\n", "case.toml:2: unknown key run.\"str.ain\"\n",
                   "a key that nothing reads", "did you mean run.strain?"},
        WrongInput{"FirstUnknownKeyInTheOrderOfTheFile", "[time]\nzeta = 1\nalpha = 1\n",
                   "case.toml:2: unknown key time.zeta\n", "", ""},
        WrongInput{"TextForNumber", "[suspension]\nsolid_fraction = \"half\"\n",
                   "case.toml:2: suspension.solid_fraction must be a number\n", "found the text \"half\"",
                   "give a number, > 0 and < 1: Volume of the particles"},
        WrongInput{"BooleanForNumber", "[run]\nstrain = true\n", "case.toml:2: run.strain must be a number\n",
                   "found true", "give a number, > 0"},
        WrongInput{"DateForNumber", "[run]\nstrain = 1999-12-31\n", "case.toml:2: run.strain must be a number\n",
                   "found a date or time", "give a number"},
        WrongInput{"ListForNumber", "[run]\nstrain = [1, 2]\n", "case.toml:2: run.strain must be a number\n",
                   "found the list [1, 2]", "give a number"},
        WrongInput{"FractionForWholeNumber", "[suspension]\ncount = 10.5\n",
                   "case.toml:2: suspension.count must be a whole number\n", "found the number 10.5",
                   "give a whole number, >= 2"},
        WrongInput{"NumberForText", "[model]\nname = 3\n", "case.toml:2: model.name must be a text\n",
                   "found the number 3", "give a text, one of \"NLM\", \"CLM\", "},
        WrongInput{"NumberForWord", "[time]\nscheme = 3\n", "case.toml:2: time.scheme must be a text\n",
                   "found the number 3", "give a text, one of \"semi-implicit\", \"explicit\", \"inertialess\""},
        WrongInput{"NumberForSwitch", "[output]\ncsv = 1\n", "case.toml:2: output.csv must be true or false\n",
                   "found the number 1", "give true or false: Write the series"},
        WrongInput{"NumberForList", "[suspension.sizes]\ndiameters = 1\n",
                   "case.toml:2: suspension.sizes.diameters must be a list of numbers\n", "found the number 1",
                   "give a list of numbers, > 0 (unit: d1)"},
        WrongInput{"TextInList", "[suspension.sizes]\ndiameters = [1, \"x\"]\n",
                   "case.toml:2: suspension.sizes.diameters must be a list of numbers\n", "found the list [1, \"x\"]",
                   "give a list of numbers"},
        WrongInput{"TwoNumbersForThree", "[suspension]\nbox_aspect = [1, 2]\n",
                   "case.toml:2: suspension.box_aspect must be a list of three numbers\n", "found the list [1, 2]",
                   "give a list of three numbers"},
        WrongInput{"EmptyFileName", "[suspension]\nfile = \"\"\n",
                   "case.toml:2: suspension.file must be the name of a file\n", "found the text \"\"",
                   "give the name of a file"},
        WrongInput{"UnknownWord", "[flow]\nboundary = \"lees-edwardz\"\n",
                   "case.toml:2: flow.boundary knows no \"lees-edwardz\"\n", "known: lees-edwards, walls, periodic",
                   "did you mean \"lees-edwards\"?"},
        WrongInput{"UnknownLaw", "[contact]\nnormal = \"glue\"\n", "case.toml:2: contact.normal knows no \"glue\"\n",
                   "known: hooke, hertz", "give one of the known words"},
        WrongInput{"UnknownModel", "[model]\nname = \"CLMS\"\n", "case.toml:2: model.name knows no \"CLMS\"\n",
                   "known: NLM, CLM, NLM-S, CLM-S, CLM-SS, GRM", "did you mean \"CLM-S\"?"},
        WrongInput{"AboveRange", "[suspension]\nsolid_fraction = 1.2\n",
                   "case.toml:2: suspension.solid_fraction is out of range\n",
                   "found the number 1.2, but it must be > 0 and < 1", "give a number > 0 and < 1"},
        WrongInput{"OnExcludedBound", "[lubrication]\ninner_cutoff = 0\n",
                   "case.toml:2: lubrication.inner_cutoff is out of range\n", "found the number 0, but it must be > 0",
                   "give a number > 0 and < 1 (unit: d_eff)"},
        WrongInput{"NegativeFriction", "[contact]\nfriction = -0.5\n",
                   "case.toml:2: contact.friction is out of range\n", "found the number -0.5, but it must be >= 0",
                   "give a number >= 0"},
        WrongInput{"NegativeSize", "[suspension.sizes]\ndiameters = [1, -1.4]\n",
                   "case.toml:2: suspension.sizes.diameters is out of range\n",
                   "found the number -1.4, but it must be > 0", "give a number > 0 (unit: d1)"},
        WrongInput{"ZeroSize", "[suspension.sizes]\ndiameters = [0, 1.4]\n",
                   "case.toml:2: suspension.sizes.diameters is out of range\n", "found the number 0, but", "give"},
        WrongInput{"TooFewParticles", "[suspension]\ncount = 1\n", "case.toml:2: suspension.count is out of range\n",
                   "found the number 1, but it must be >= 2", "give a number >= 2"},
        WrongInput{"NotANumber", "[contact]\nfriction = nan\n",
                   "case.toml:2: contact.friction is not a finite number\n", "found the number nan",
                   "give a number >= 0"},
        WrongInput{"Infinite", "[output]\nsample_every = inf\n",
                   "case.toml:2: output.sample_every is not a finite number\n", "found the number inf",
                   "give a number"},
        WrongInput{"NotANumberInAList", "[suspension]\nbox_aspect = [1, nan, 1]\n",
                   "case.toml:2: suspension.box_aspect is not a finite number\n", "found the number nan",
                   "give a number"},
        WrongInput{"MissingStrain", "[suspension]\nsolid_fraction = 0.5\n[run]\nthreads = 1\n",
                   "case.toml:3: run.strain is missing\n", "it has no default: Strain at which the run ends",
                   "add strain = ... to [run], > 0"},
        WrongInput{"MissingSection", "[suspension]\nsolid_fraction = 0.5\n", "case.toml: run.strain is missing\n",
                   "it has no default", "add strain = ... to [run]"},
        WrongInput{"EmptyDocument", "", "case.toml: run.strain is missing\n", "it has no default", "add strain"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST(Message, LongValuesAreShortened) {
  const std::string message = complaint_of("[contact]\nnormal = \"" + std::string(5000, 'x') + "\"\n");
  EXPECT_THAT(message, HasSubstr("xxx...\n"));
  EXPECT_LT(message.size(), 400u);
}

TEST(Message, OversizedInputIsRefused) {
  EXPECT_THAT(complaint_of(std::string(2 << 20, '#')), StartsWith("case.toml: the input is larger than 1 MiB\n"));
  EXPECT_THAT(complaint_of("a" + std::string(100'000, '.') + "b = 1\n"), HasSubstr("100000 dots and opening brackets"));
}

TEST(Message, InputFileMustExistAndBeAFile) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "input-that-is-a-folder";
  std::filesystem::create_directories(folder);
  const std::string no_file = complaint_of([&] { read_case(folder / "absent.toml"); });
  EXPECT_THAT(no_file, StartsWith((folder / "absent.toml").string() + ": the input file cannot be opened\n"));
  EXPECT_THAT(no_file, HasSubstr("stresslet new"));
  EXPECT_THAT(complaint_of([&] { read_case(folder); }), HasSubstr(": this is a folder\n"));
}

TEST(Message, PathOfTheFileStandsInMessages) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "wrong.toml";
  std::ofstream(file) << "[run]\nstrain = -1\n";
  EXPECT_THAT(complaint_of([&] { read_case(file); }), StartsWith(file.string() + ":2: run.strain is out of range\n"));
}

}  // namespace
}  // namespace stresslet
