/// The harness of the validation cases: verdicts, orders, files, exit codes, names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "../program.hpp"
#include "stresslet/io/csv.hpp"
#include "validation/cases.hpp"
#include "validation/harness/convergence.hpp"
#include "validation/harness/report.hpp"
#include "validation/harness/validate.hpp"

namespace stresslet::validation {
namespace {

using ::testing::HasSubstr;

Row row(double value, double reference, Tolerance tolerance) {
  return {"quantity", {reference, "book"}, value, tolerance};
}

TEST(ValidationRow, IsBoundedOnBothSides) {
  EXPECT_TRUE(row(2.02, 2, relative(0.011)).passes());
  EXPECT_TRUE(row(1.98, 2, relative(0.011)).passes());
  EXPECT_FALSE(row(2.03, 2, relative(0.011)).passes());
  EXPECT_FALSE(row(1.97, 2, relative(0.011)).passes());
  EXPECT_FALSE(row(1.97, 2, absolute(0.02)).passes());
  EXPECT_TRUE(row(0.01, 0, absolute(0.02)).passes());
  EXPECT_FALSE(row(-0.03, 0, absolute(0.02)).passes());
  EXPECT_TRUE(row(2.3, 2, {false, -0.2, 0.3}).passes());
  EXPECT_FALSE(row(1.7, 2, {false, -0.2, 0.3}).passes());
}

TEST(ValidationRow, ErrorHasTheSignOfTheExcessForNegativeReferencesToo) {
  EXPECT_DOUBLE_EQ(row(-1, -2, relative(1)).error(), 0.5);
  EXPECT_DOUBLE_EQ(row(-3, -2, relative(1)).error(), -0.5);
}

TEST(ValidationRow, WhatIsNoNumberFails) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(row(nan, 1, relative(1)).passes());
  EXPECT_FALSE(row(infinity, 1, relative(1)).passes());
  EXPECT_FALSE(row(1, 0, relative(1)).passes());
}

TEST(ValidationConvergence, OrderOfAPowerLaw) {
  EXPECT_NEAR(observed_order(8, 3.0 / 64, 24, 3.0 / 576), 2, 1e-12);
  EXPECT_NEAR(observed_order(10, -0.5, 20, 0.25), 1, 1e-12);
}

TEST(ValidationConvergence, NormsOfKnownVectors) {
  const std::vector<double> exact{3, 4}, found{3, 4.5}, none{3, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_DOUBLE_EQ(relative_l2_error(found, exact), 0.1);
  EXPECT_DOUBLE_EQ(largest_difference(found, exact), 0.5);
  EXPECT_TRUE(std::isnan(largest_difference(none, exact)));
}

void good(Trial& trial) {
  trial.parameter("cells", trial.choose(64.0, 32.0));
  trial.parameter("stencil", "D2Q9");
  trial.row("viscosity", 1.001, {1, "book"}, relative(0.01));
  trial.table({"profile", {{"y", "H", ""}, {"u", "", ""}}, {{0.25, 0.75}, {1, 3}}});
}
void wrong(Trial& trial) {
  good(trial);
  trial.row("drag", 3, {2, "book"}, absolute(0.5));
}
void empty(Trial&) {}

TEST(Validation, WritesRowsParametersAndProvenance) {
  const program::Workplace place;
  const Case what{"G1", "G1-good", "a good case", good};
  const ValidateOptions options{
      .output = place / "out", .folder_per_case = false, .quick = true, .quiet = true, .command_line = "stresslet me"};
  EXPECT_EQ(validate(std::span(&what, 1), options), ExitCode::success);
  const auto j = nlohmann::json::parse(program::content_of(place / "out/validation.json"));
  EXPECT_EQ(j["id"], "G1");
  EXPECT_EQ(j["quick"], true);
  EXPECT_EQ(j["verdict"], "pass");
  EXPECT_EQ(j["parameters"]["cells"], 32);
  EXPECT_EQ(j["parameters"]["stencil"], "D2Q9");
  ASSERT_EQ(j["rows"].size(), 1u);
  const auto& r = j["rows"][0];
  EXPECT_EQ(r["quantity"], "viscosity");
  EXPECT_EQ(r["reference"], 1);
  EXPECT_EQ(r["source"], "book");
  EXPECT_EQ(r["value"], 1.001);
  EXPECT_NEAR(r["error"], 0.001, 1e-12);
  EXPECT_EQ(r["error_is"], "relative");
  EXPECT_EQ(r["tolerance"], nlohmann::json({-0.01, 0.01}));
  EXPECT_EQ(r["verdict"], "pass");
  EXPECT_EQ(j["provenance"]["command_line"], "stresslet me");
  EXPECT_FALSE(j["provenance"]["commit"].get<std::string>().empty());
  const CsvTable table = read_csv(place / "out/profile.csv");
  EXPECT_EQ(table.column("u"), (std::vector<double>{1, 3}));
  EXPECT_EQ(table.units[0], "H");
}

TEST(Validation, AWrongRowFailsTheCaseAndTheRun) {
  const program::Workplace place;
  const std::vector<Case> both{{"G1", "G1-good", "a good case", good}, {"W1", "W1-wrong", "a wrong case", wrong}};
  const ValidateOptions options{.output = place / "out", .quiet = true};
  EXPECT_EQ(validate(both, options), ExitCode::disagreement);
  EXPECT_EQ(int(ExitCode::disagreement), 5);
  const auto j = nlohmann::json::parse(program::content_of(place / "out/W1/validation.json"));
  EXPECT_EQ(j["verdict"], "fail");
  EXPECT_EQ(j["rows"][0]["verdict"], "pass");
  EXPECT_EQ(j["rows"][1]["verdict"], "fail");
  EXPECT_EQ(nlohmann::json::parse(program::content_of(place / "out/G1/validation.json"))["verdict"], "pass");
}

TEST(Validation, ACaseWithoutRowsFails) {
  const program::Workplace place;
  const Case what{"E1", "E1-empty", "an empty case", empty};
  EXPECT_EQ(validate(std::span(&what, 1), {.output = place / "out", .quiet = true}), ExitCode::disagreement);
}

TEST(Validation, TableShowsEveryColumn) {
  Trial trial(false, 1, true);
  wrong(trial);
  const std::string text = table_text({"W1", "W1-wrong", "a wrong case", wrong}, trial);
  for (const char* part : {"quantity", "reference", "value", "error", "tolerance", "verdict", "source", "viscosity",
                           "1.001", "+1.0e-03 rel", "book", "FAIL", "W1: FAIL, 1 of 2 rows"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(Validation, FolderThatCannotBeMadeIsExplained) {
  const program::Workplace place;
  const std::string file = place.write("file", "");
  const Case what{"G1", "G1-good", "a good case", good};
  EXPECT_THROW(validate(std::span(&what, 1), {.output = file + "/out", .quiet = true}), InputError);
}

TEST(ValidationCases, HaveNamesOfTheirOwnAndAFolderWithAReadme) {
  std::set<std::string_view> ids, folders;
  for (const Case& c : cases()) {
    EXPECT_TRUE(ids.insert(c.id).second) << c.id;
    EXPECT_TRUE(folders.insert(c.folder).second) << c.folder;
    const std::filesystem::path folder =
        std::filesystem::path(STRESSLET_SOURCE_DIR) / "validation" / std::string(c.folder);
    EXPECT_TRUE(std::filesystem::exists(folder / "README.md")) << folder;
    EXPECT_EQ(&case_called(c.id), &c);
  }
}

TEST(ValidationCases, UnknownNameGetsTheNearestKnownOne) {
  try {
    case_called("l12");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there is no validation case \"l12\""));
    EXPECT_THAT(error.what(), HasSubstr("L1, L2, L3"));
    EXPECT_THAT(error.what(), HasSubstr("did you mean L12?"));
  }
}

}  // namespace
}  // namespace stresslet::validation
