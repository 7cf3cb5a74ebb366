/// Every operator starts with a weight that it bears.
#include <gtest/gtest.h>

#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/weight_choice.hpp"

namespace stresslet {
namespace {

TEST(WeightChoice, DefaultsAreBorne) {
  for (const std::string& name : CouplingOperators::names()) EXPECT_TRUE(bears(name, default_weight(name))) << name;
}

TEST(WeightChoice, WeightsUpToTwoGoWithForcesAlone) {
  for (const std::string& name : CouplingOperators::names())
    EXPECT_EQ(bears(name, "viscosity-scaled"), name == "superposition" || name == "guo-form") << name;
}

}  // namespace
}  // namespace stresslet
