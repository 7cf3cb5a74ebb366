/// Every size distribution: as many particles as asked for, positive sizes, valid species, the same each time,
/// and independent of the count in the mean.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/sizes/laws.hpp"

namespace stresslet {
namespace {

template <class Law>
struct Example {
  static typename Law::Params params() { return {}; }
};
template <>
struct Example<Discrete> {
  static Discrete::Params params() { return {{1, 1.4, 2}, {}, {1, 1, 1}}; }
};
template <>
struct Example<Table> {
  static Table::Params params() { return {{1, 1.5, 2}, {0, 1, 2}, Table::Basis::volume}; }
};

template <class List>
struct AsTypes;
template <class... Laws>
struct AsTypes<TypeList<Laws...>> {
  using type = testing::Types<Laws...>;
};

template <class Law>
class SizeDistribution : public testing::Test {};
TYPED_TEST_SUITE(SizeDistribution, AsTypes<SizeDistributionLaws>::type);

double mean_volume(const std::vector<SizeClassed>& sizes) {
  double sum = 0;
  for (const auto& s : sizes) sum += s.diameter * s.diameter * s.diameter;
  return sum / double(sizes.size());
}

TYPED_TEST(SizeDistribution, GivesTheCountWithPositiveSizes) {
  const auto params = Example<TypeParam>::params();
  TypeParam::validate(params);
  for (std::size_t count : {20u, 500u, 1237u}) {
    const auto sizes = TypeParam::sizes(params, count);
    ASSERT_EQ(sizes.size(), count);
    for (const auto& s : sizes) {
      EXPECT_TRUE(std::isfinite(s.diameter) && s.diameter > 0);
      EXPECT_GE(s.species, 0);
      EXPECT_LT(s.species, 3);
    }
  }
}

TYPED_TEST(SizeDistribution, IsTheSameEachTime) {
  const auto params = Example<TypeParam>::params();
  EXPECT_EQ(TypeParam::sizes(params, 321), TypeParam::sizes(params, 321));
}

TYPED_TEST(SizeDistribution, MeanVolumeConvergesWithTheCount) {
  const auto params = Example<TypeParam>::params();
  const double fine = mean_volume(TypeParam::sizes(params, 100000));
  EXPECT_NEAR(mean_volume(TypeParam::sizes(params, 1000)), fine, 0.005 * fine);
  EXPECT_NEAR(mean_volume(TypeParam::sizes(params, 10000)), fine, 0.0005 * fine);
}

TYPED_TEST(SizeDistribution, IsFoundByName) {
  EXPECT_TRUE(SizeDistributionLaws::dispatch(TypeParam::name,
                                             [](auto tag) { EXPECT_EQ(decltype(tag)::type::name, TypeParam::name); }));
  EXPECT_FALSE(TypeParam::summary.empty());
}

TEST(SizeDistributionLaws, Names) {
  EXPECT_EQ(SizeDistributionLaws::names(),
            (std::vector<std::string>{"monodisperse", "discrete", "lognormal", "table"}));
}

TEST(Monodisperse, RefusesSizesThatAreNotPositive) {
  for (double d : {0.0, -1.0, std::nan(""), HUGE_VAL}) EXPECT_THROW(Monodisperse::validate({d}), InputError);
}

}  // namespace
}  // namespace stresslet
