#include <gtest/gtest.h>

#include "stresslet/base/error.hpp"
#include "stresslet/io/input_document.hpp"
#include "stresslet/io/nearest_word.hpp"

namespace stresslet {
namespace {

double number(InputDocument& document, const std::string& key) {
  const InputValue* value = document.look_up(key);
  return value ? std::get<double>(value->content) : -1;
}

TEST(InputDocument, KeepsTheLineOfEveryKey) {
  auto document = InputDocument::from_text("a = 1.0\n\n[b]\nc = [1,\n 2]\nd.e = 2.0\nf = { g = 3.0 }\n", "x.toml");
  EXPECT_EQ(document.where("a"), "x.toml:1");
  EXPECT_EQ(document.where("b"), "x.toml:3");
  EXPECT_EQ(document.where("b.c"), "x.toml:4");
  EXPECT_EQ(document.where("b.d.e"), "x.toml:6");
  EXPECT_EQ(document.where("b.f.g"), "x.toml:7");
  EXPECT_EQ(document.where("b.absent.deeper"), "x.toml:3");
  EXPECT_EQ(document.where("absent"), "x.toml");
  EXPECT_EQ(number(document, "b.f.g"), 3);
  EXPECT_TRUE(document.is_section("b.f"));
  EXPECT_FALSE(document.is_section("b.c"));
}

TEST(InputDocument, ListsUnreadKeysInTheOrderOfTheText) {
  auto document = InputDocument::from_text("[z]\nb = 1\na = 2\n[y]\nc = 3\n", "x.toml");
  document.override_key("a.first=1");
  EXPECT_EQ(document.unread(), (std::vector<std::string>{"z", "z.b", "z.a", "y", "y.c", "a", "a.first"}));
  document.look_up("z");
  document.look_up("z.a");
  EXPECT_EQ(document.unread(), (std::vector<std::string>{"z.b", "y", "y.c", "a", "a.first"}));
}

TEST(InputDocument, OverridesAreTomlOrBareText) {
  auto document = InputDocument::from_text("[run]\nstrain = 1.0\n", "x.toml");
  const auto overridden = [&](const std::string& assignment) {
    document.override_key(assignment);
    return document.look_up("run.strain")->content;
  };
  EXPECT_EQ(std::get<double>(overridden("run.strain=2.5")), 2.5);
  EXPECT_EQ(std::get<std::int64_t>(overridden(" run.strain = 3 ")), 3);
  EXPECT_EQ(std::get<bool>(overridden("run.strain=true")), true);
  EXPECT_EQ(std::get<std::string>(overridden("run.strain=\"CLM-S\"")), "CLM-S");
  EXPECT_EQ(std::get<std::string>(overridden("run.strain=CLM-S")), "CLM-S");
  EXPECT_EQ(std::get<std::string>(overridden("run.strain=a=b \"c\" \\d")), "a=b \"c\" \\d");
  EXPECT_EQ(std::get<std::string>(overridden("run.strain=1\nrun.other=2")), "1\nrun.other=2");
  EXPECT_EQ(std::get<InputValue::List>(overridden("run.strain=[1, 2]")).size(), 2u);
  EXPECT_EQ(document.where("run.strain"), "--set run.strain=[1, 2]");
  document.override_key("run={strain=7.0}");
  EXPECT_EQ(number(document, "run.strain"), 7);
}

TEST(InputDocument, AnEmptyOverrideRemovesAKeyButStillHasToBeKnown) {
  auto document = InputDocument::from_text("[run]\nstrain = 1.0\n", "x.toml");
  document.override_key("run.strain=");
  EXPECT_EQ(document.unread(), (std::vector<std::string>{"run", "run.strain"}));
  EXPECT_EQ(document.look_up("run.strain"), nullptr);
  EXPECT_EQ(document.unread(), (std::vector<std::string>{"run"}));
  document.override_key("run=");
  EXPECT_EQ(document.look_up("run"), nullptr);
}

TEST(InputDocument, AnOverrideDoesNotReachIntoAValue) {
  auto document = InputDocument::from_text("[run]\nstrain = 1.0\n", "x.toml");
  try {
    document.override_key("run.strain.total=2");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--set run.strain.total=2: run.strain is a value, not a section\n  why: given at x.toml:2\n"
                 "  fix: drop what follows it in the key");
  }
}

TEST(EditDistance, CountsEditsAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("fractoin", "fraction"), 1u);
  EXPECT_EQ(edit_distance("flaw", "lawn"), 2u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u);  // 2 for the unrestricted Damerau distance
}

TEST(NearestWord, IsTheOneWithTheFewestEdits) {
  EXPECT_EQ(nearest_word("fraction", {"faction", "friction"}), "friction");
  EXPECT_EQ(nearest_word("strian", {"strain", "train"}), "strain");
  EXPECT_EQ(nearest_word("CLMS", {"CLM", "CLM-S"}), "CLM-S");
  EXPECT_EQ(nearest_word("xylophone", {"strain", "step"}), std::nullopt);
  EXPECT_EQ(nearest_word("ab", {"xy"}), std::nullopt);
  EXPECT_EQ(nearest_word(std::string(100'000, 'a'), {"strain"}), std::nullopt);
}

}  // namespace
}  // namespace stresslet
