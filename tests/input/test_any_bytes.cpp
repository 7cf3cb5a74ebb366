/// Whatever bytes are given, the reader answers with a case or an InputError, and a case survives writing and reading.
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <random>
#include <sstream>
#include <string>

#include "read_any.hpp"
#include "stresslet/io/schema_read.hpp"

namespace stresslet {
namespace {

using Random = std::mt19937_64;

std::size_t below(Random& random, std::size_t bound) {
  return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random);
}

std::string random_bytes(Random& random, std::size_t longest) {
  std::string bytes(below(random, longest), '\0');
  for (char& byte : bytes) byte = char(below(random, 256));
  return bytes;
}

/// One to eight small damages: a byte changed, a piece dropped, doubled, or replaced by a piece of TOML.
std::string damaged(std::string text, Random& random) {
  static constexpr std::array<std::string_view, 24> pieces{"[",
                                                           "]",
                                                           "[[",
                                                           "{",
                                                           "}",
                                                           "=",
                                                           ".",
                                                           ",",
                                                           "\"",
                                                           "'''",
                                                           "\"\"\"",
                                                           "\n",
                                                           "\r\n",
                                                           "#",
                                                           "nan",
                                                           "-inf",
                                                           "1e999",
                                                           "-0",
                                                           "0x7fffffffffffffff",
                                                           "9223372036854775808",
                                                           "1979-05-27T07:32:00Z",
                                                           "true",
                                                           "\\u0000",
                                                           "\xff"};
  for (std::size_t damage = 1 + below(random, 8); damage > 0 && !text.empty(); --damage) {
    const std::size_t at = below(random, text.size());
    const std::size_t length = below(random, std::min<std::size_t>(40, text.size() - at) + 1);
    switch (below(random, 4)) {
      case 0:
        text[at] = char(below(random, 256));
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(below(random, text.size()), text.substr(at, length));
        break;
      default:
        text.replace(at, length, pieces[below(random, pieces.size())]);
    }
  }
  return text;
}

std::string example_text() {
  std::ostringstream text;
  text << std::ifstream(std::string(STRESSLET_SOURCE_DIR) + "/examples/shear-lubricated/case.toml").rdbuf();
  return text.str();
}

TEST(AnyBytes, RandomBytesAreRefused) {
  Random random(1);
  for (int trial = 0; trial < 3000; ++trial) EXPECT_EQ(read_any(random_bytes(random, 200)), 0);
}

TEST(AnyBytes, DamagedInputsAreReadOrRefused) {
  Random random(2);
  const std::array<std::string, 3> seeds{example_text(), new_case_template(),
                                         "[suspension]\nsolid_fraction = 0.5\n[run]\nstrain = 1\n"};
  int accepted = 0;
  const int trials = 6000;
  for (int trial = 0; trial < trials; ++trial)
    accepted += read_any(damaged(seeds[below(random, seeds.size())], random));
  EXPECT_GT(accepted, trials / 50);
  EXPECT_LT(accepted, trials / 2);
}

TEST(AnyBytes, RandomValuesOfKnownKeysAreReadOrRefused) {
  static constexpr std::array<std::string_view, 20> values{"0.5",   "1",           "2e5",       "0.01",      "true",
                                                           "false", "\"hertz\"",   "\"GRM\"",   "\"walls\"", "[1, 1.4]",
                                                           "[1]",   "[0.4, 0.6]",  "[1, 2, 3]", "lognormal", "table",
                                                           "none",  "inertialess", "spring",    "",          "-3"};
  KeyCollector known;
  Case().describe(known);
  Random random(3);
  int accepted = 0;
  const int trials = 6000;
  for (int trial = 0; trial < trials; ++trial) {
    std::string bytes = "[suspension]\nsolid_fraction = 0.5\n[run]\nstrain = 1\n";
    for (std::size_t key = 1 + below(random, 3); key > 0; --key)
      bytes += "\xff" + known.keys[below(random, known.keys.size())] + "=" +
               std::string(values[below(random, values.size())]);
    accepted += read_any(bytes);
  }
  EXPECT_GT(accepted, trials / 50);
  EXPECT_LT(accepted, trials / 2);
}

TEST(AnyBytes, DeepNestingIsReadOrRefused) {
  for (const std::size_t depth : {10u, 300u, 3900u, 100'000u}) {
    std::string dotted = "a", arrays, tables, headers = "[a";
    for (std::size_t level = 0; level < depth; ++level) {
      dotted += ".a";
      arrays += "[";
      tables += "{a=";
      headers += ".a";
    }
    EXPECT_EQ(read_any(dotted + " = 1\n"), 0);
    EXPECT_EQ(read_any("a = " + arrays + "\n"), 0);
    EXPECT_EQ(read_any("a = " + tables + "\n"), 0);
    EXPECT_EQ(read_any(headers + "]\n"), 0);
    EXPECT_EQ(read_any("\xff" + dotted + "=1"), 0);
    EXPECT_EQ(read_any("\xff"
                       "a=" +
                       arrays),
              0);
  }
}

TEST(AnyBytes, StrangeOverridesAreRefused) {
  for (const char* assignment : {"", "=", "=1", ".", "a..b=1", "run.strain", " .run=1", "run.strain.x=1",
                                 "run=", "run.strain=1\n[x]", "suspension.file=\xc3\x28", "model.name=\x01"})
    EXPECT_EQ(
        read_any(std::string("[suspension]\nsolid_fraction = 0.5\n[run]\nstrain = 1\n\xff") + assignment + "\xff"), 0)
        << assignment;
}

}  // namespace
}  // namespace stresslet
