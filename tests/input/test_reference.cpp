/// docs/input-reference.md is generated: it lists every key and is current.
/// `STRESSLET_UPDATE_REFERENCE=1 build/tests/test_input --gtest_filter='InputReference.*'` writes it anew.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "stresslet/io/schema_read.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/fluid/case.hpp"
#include "stresslet/simulation/reference.hpp"

namespace stresslet {
namespace {

template <class AnyCase>
void expect_every_key(const std::string& reference) {
  KeyCollector collector;
  AnyCase().describe(collector);
  EXPECT_GE(collector.keys.size(), 45u);
  for (const std::string& path : collector.keys) {
    const std::size_t dot = path.rfind('.');
    const std::size_t section = reference.find("## [" + path.substr(0, dot) + "]\n");
    ASSERT_NE(section, std::string::npos) << path;
    const std::size_t end = reference.find("\n## [", section);
    EXPECT_THAT(reference.substr(section, end - section), ::testing::HasSubstr("\n| `" + path.substr(dot + 1) + "` |"));
  }
}

TEST(InputReference, ListsEveryKeyInItsSection) {
  const std::string reference = input_reference_markdown();
  const std::size_t fluid = reference.find("\n# Fluid cases\n");
  ASSERT_NE(fluid, std::string::npos);
  expect_every_key<Case>(reference.substr(0, fluid));
  expect_every_key<FluidCase>(reference.substr(fluid));
}

TEST(InputReference, NamesChoicesUnitsRangesAndDefaults) {
  const std::string reference = input_reference_markdown();
  EXPECT_THAT(reference, ::testing::HasSubstr("| `solid_fraction` | a number, > 0 and < 1 | 1 | required unless"));
  EXPECT_THAT(reference, ::testing::HasSubstr("one of \"semi-implicit\", \"explicit\", \"inertialess\" |"));
  EXPECT_THAT(reference, ::testing::HasSubstr("| `strain` | a number, > 0 and <= 1000000 | 1 | required |"));
  EXPECT_THAT(reference, ::testing::HasSubstr("| `outer_cutoff` | a number, > 0 and < 1 | d_eff | `0.05` |"));
}

TEST(InputReference, TheCommittedFileIsCurrent) {
  const std::string path = std::string(STRESSLET_SOURCE_DIR) + "/docs/input-reference.md";
  if (std::getenv("STRESSLET_UPDATE_REFERENCE")) std::ofstream(path) << input_reference_markdown();
  std::ostringstream committed;
  committed << std::ifstream(path).rdbuf();
  EXPECT_EQ(committed.str(), input_reference_markdown()) << "write it anew with STRESSLET_UPDATE_REFERENCE=1";
}

}  // namespace
}  // namespace stresslet
