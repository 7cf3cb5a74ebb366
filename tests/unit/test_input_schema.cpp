#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stresslet/io/schema_read.hpp"
#include "stresslet/io/schema_text.hpp"

namespace stresslet {
namespace {

struct Wheel {
  double radius = 0.3;
  std::optional<std::int64_t> spokes;
  template <class V>
  void describe(V& v) {
    v.key("radius", radius, defaulted, above(0), "m", "Radius of the wheel");
    v.key("spokes", spokes, otherwise("a disc"), at_least(3), "1", "Number of spokes");
  }
  friend bool operator==(const Wheel&, const Wheel&) = default;
};

struct Garage {
  Wheel front;
  std::optional<Wheel> spare;
  template <class V>
  void describe(V& v) {
    v.section("front", front, "The front wheel.");
    v.section("spare", spare, "A spare wheel.");
  }
  friend bool operator==(const Garage&, const Garage&) = default;
};

Garage read(const std::string& text) {
  auto document = InputDocument::from_text(text, "garage.toml");
  return read_described<Garage>(document);
}

TEST(Schema, ReadsDefaultsOptionalKeysAndOptionalSections) {
  EXPECT_EQ(read(""), Garage{});
  EXPECT_EQ(read("[spare]\n").spare, Wheel{});
  EXPECT_EQ(read("[front]\nradius = 1\nspokes = 30.0\n").front, (Wheel{1.0, 30}));
}

TEST(Schema, WritesWhatItReads) {
  EXPECT_EQ(resolved_text(described(Garage{})), "[front]\nradius = 0.3\n# spokes: a disc\n\n# [spare] is not given\n");
  const Garage full{{0.1, 8}, Wheel{1e-300, std::nullopt}};
  EXPECT_EQ(read(resolved_text(described(full))), full);
}

TEST(Schema, TemplateExplainsAndCommentsOutDefaults) {
  EXPECT_EQ(template_text(described(Garage{{0.3, 8}, std::nullopt})),
            "# The front wheel.\n[front]\n\n"
            "# Radius of the wheel (a number, > 0, in m)\n# radius = 0.3\n\n"
            "# Number of spokes (a whole number, >= 3)\nspokes = 8\n\n"
            "# A spare wheel.\n# [spare]\n\n"
            "# Radius of the wheel (a number, > 0, in m)\n# radius = 0.3\n\n"
            "# Number of spokes (a whole number, >= 3)\n# spokes =     # a disc\n");
}

TEST(Schema, TextOfChecks) {
  EXPECT_EQ(anything().text(), "");
  EXPECT_EQ(above_up_to(0, 1).text(), "> 0 and <= 1");
  EXPECT_EQ(one_of({"a", "b"}).text(), "one of \"a\", \"b\"");
  EXPECT_TRUE(above_up_to(0, 1).holds(1));
  EXPECT_FALSE(above_up_to(0, 1).holds(0));
  EXPECT_FALSE(strictly_between(0, 1).holds(1));
}

TEST(TomlText, KeepsEveryDigitAndEscapes) {
  EXPECT_EQ(toml_text({0.1, {}, {}}), "0.1");
  EXPECT_EQ(toml_text({10.0, {}, {}}), "10.0");
  EXPECT_EQ(toml_text({1e300, {}, {}}), "1e+300");
  EXPECT_EQ(toml_text({2.0 / 7.0, {}, {}}), "0.2857142857142857");
  EXPECT_EQ(toml_text({std::string("a\"\\\n\x7f"), {}, {}}), R"("a\"\\\u000a\u007f")");
}

}  // namespace
}  // namespace stresslet
