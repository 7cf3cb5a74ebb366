/// Every validation case passes in its quick version, started as a user does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "../program.hpp"
#include "validation/cases.hpp"

namespace stresslet {
namespace {

using namespace program;
using ::testing::HasSubstr;

class ValidateQuick : public ::testing::TestWithParam<std::string> {};

TEST_P(ValidateQuick, Passes) {
  const Workplace place;
  const Outcome outcome = stresslet({"validate", GetParam(), "--quick", "--quiet", "--output", place / "out"});
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  const auto j = nlohmann::json::parse(content_of(place / "out/validation.json"));
  EXPECT_EQ(j["id"], GetParam());
  EXPECT_EQ(j["verdict"], "pass");
  EXPECT_FALSE(j["rows"].empty());
}

std::vector<std::string> all_ids() {
  std::vector<std::string> ids;
  for (const auto& c : validation::cases()) ids.emplace_back(c.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Cases, ValidateQuick, ::testing::ValuesIn(all_ids()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(Validate, ListShowsEveryCase) {
  const Outcome outcome = stresslet({"validate", "list"});
  EXPECT_EQ(outcome.code, 0);
  for (const auto& c : validation::cases()) EXPECT_THAT(outcome.out, HasSubstr(std::string(c.title)));
}

TEST(Validate, UnknownCaseIsRefusedBeforeAnythingRuns) {
  const Workplace place;
  const Outcome outcome = stresslet({"validate", "L1", "L33", "--output", place / "out"});
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("L33"));
  EXPECT_THAT(outcome.err, HasSubstr("did you mean"));
  EXPECT_FALSE(std::filesystem::exists(place / "out"));
}

}  // namespace
}  // namespace stresslet
