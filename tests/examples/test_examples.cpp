/// Every folder under examples/ runs, shortened, and its check.py agrees; the Long ones run in full.
#include <gtest/gtest.h>

#include <algorithm>

#include "../program.hpp"

namespace stresslet {
namespace {

using namespace program;

std::vector<std::string> example_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(STRESSLET_SOURCE_DIR "/examples"))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

class Example : public ::testing::TestWithParam<std::string> {
 protected:
  std::string file(const std::string& name) const {
    return (std::filesystem::path(STRESSLET_SOURCE_DIR) / "examples" / GetParam() / name).string();
  }

  /// Settings with which the example runs for a moment only.
  std::vector<std::string> shortened() const {
    const std::string text = content_of(file("case.toml"));
    if (text.find("fidelity = \"resolved\"") != std::string::npos)
      return {"run.strain=0.05", "run.average_from=0.02", "run.threads=1"};
    if (text.find("fidelity = \"fluid\"") == std::string::npos)
      return {"suspension.count=150", "run.strain=0.05", "run.average_from=0.01", "run.threads=1"};
    const std::string key = "end_time = ";
    const std::string end = std::to_string(0.01 * std::stod(text.substr(text.find(key) + key.size())));
    return {"run.end_time=" + end, "output.sample_every=" + end, "output.fields_every=" + end, "run.threads=1"};
  }

  void run_and_check(const std::vector<std::string>& assignments, bool quick) const {
    const Workplace place;
    const Outcome run = stresslet(run_arguments(file("case.toml"), place / "results", assignments));
    ASSERT_EQ(run.code, 0) << run.err;
    std::vector<std::string> command{"/usr/bin/python3", file("check.py"), place / "results"};
    if (quick) command.push_back("--quick");
    const Outcome check = Process(command).wait();
    EXPECT_EQ(check.code, 0) << check.out << check.err;
  }
};

TEST_P(Example, ExplainsItself) {
  EXPECT_GT(content_of(file("README.md")).size(), 500u);
  EXPECT_EQ(stresslet({"check", file("case.toml")}).code, 0);
}

TEST_P(Example, RunsShortenedAndChecksItself) { run_and_check(shortened(), true); }

class LongExample : public Example {};

TEST_P(LongExample, RunsInFullAndChecksItself) { run_and_check({}, false); }

std::string test_name(const ::testing::TestParamInfo<std::string>& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Examples, Example, ::testing::ValuesIn(example_names()), test_name);
INSTANTIATE_TEST_SUITE_P(Examples, LongExample, ::testing::ValuesIn(example_names()), test_name);

/// A check that cannot fail checks nothing.
TEST(ExampleCheck, NoticesAWrongSummary) {
  const Workplace place;
  const std::string folder = STRESSLET_SOURCE_DIR "/examples/shear-lubricated/";
  ASSERT_EQ(stresslet(run_arguments(folder + "case.toml", place / "results",
                                    {"suspension.count=100", "run.strain=0.01", "run.average_from=0"}))
                .code,
            0);
  std::string summary = content_of(place / "results/summary.json");
  const std::string key = "\"stresslet\": {\n      \"mean\": 1.";
  ASSERT_NE(summary.find(key), std::string::npos);
  summary[summary.find(key) + key.size() - 2] = '2';
  place.write("results/summary.json", summary);
  EXPECT_EQ(Process({"python3", folder + "check.py", place / "results", "--quick"}).wait().code, 1);
}

}  // namespace
}  // namespace stresslet
