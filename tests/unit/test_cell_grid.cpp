#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <utility>

#include "stresslet/particles/cell_grid.hpp"

namespace stresslet {
namespace {

using Pairs = std::set<std::pair<int, int>>;

struct Cloud {
  Box box;
  std::vector<double> x, y, z, radius;
  std::size_t size() const { return x.size(); }
  Vec3<double> position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  bool within(std::size_t i, std::size_t j, double gap) const {
    return norm(box.nearest_image(position(j) - position(i)).r) < radius[i] + radius[j] + gap;
  }
};

/// Positions also on faces and in corners; radii over a factor of twenty.
Cloud random_cloud(std::mt19937_64& random, BoxKind kind, double smallest_length, std::size_t n) {
  std::uniform_real_distribution<double> unit(0, 1);
  Cloud cloud;
  cloud.box.kind = kind;
  cloud.box.length = {smallest_length * (1 + 2 * unit(random)), smallest_length * (1 + 2 * unit(random)),
                      smallest_length * (1 + 2 * unit(random))};
  if (kind == BoxKind::lees_edwards) cloud.box.offset = cloud.box.length.x * unit(random);
  const auto coordinate = [&](double length) {
    const double u = unit(random);
    return u < 0.03 ? 0.0 : u < 0.06 ? std::nextafter(length, 0.0) : length * unit(random);
  };
  for (std::size_t i = 0; i < n; ++i) {
    cloud.x.push_back(coordinate(cloud.box.length.x));
    cloud.y.push_back(coordinate(cloud.box.length.y));
    cloud.z.push_back(coordinate(cloud.box.length.z));
    cloud.radius.push_back(0.5 * std::pow(0.05, unit(random)));
  }
  return cloud;
}

Pairs pairs_by_brute_force(const Cloud& cloud, double gap) {
  Pairs pairs;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t j = i + 1; j < cloud.size(); ++j)
      if (cloud.within(i, j, gap)) pairs.insert({int(i), int(j)});
  return pairs;
}

/// Inserts pairs and fails where one comes twice.
void insert_once(Pairs& pairs, int i, int j) {
  EXPECT_TRUE(pairs.insert({std::min(i, j), std::max(i, j)}).second) << i << " " << j;
}

class CellGridOf : public testing::TestWithParam<BoxKind> {};

TEST_P(CellGridOf, FindsThePairsOfBruteForceOnce) {
  std::mt19937_64 random(7);
  const double gap = 0.1;
  for (double smallest_length : {2.2, 3.0, 5.0, 9.0})
    for (double cell_size : {0.2, 0.6, 1.1, 3.0})
      for (int trial = 0; trial < 8; ++trial) {
        const Cloud cloud = random_cloud(random, GetParam(), smallest_length, 150);
        CellGrid grid;
        grid.build(cloud.box, cloud.x, cloud.y, cloud.z, cell_size);
        const Pairs expected = pairs_by_brute_force(cloud, gap);
        const double largest = *std::max_element(cloud.radius.begin(), cloud.radius.end());

        Pairs by_index, by_size;
        for (std::size_t i = 0; i < cloud.size(); ++i) {
          const double a = cloud.radius[i];
          grid.for_each_candidate(cloud.position(i), a + largest + gap, [&](std::int32_t j) {
            if (std::size_t(j) > i && cloud.within(i, std::size_t(j), gap)) insert_once(by_index, int(i), j);
          });
          grid.for_each_candidate(cloud.position(i), 2 * a + gap, [&](std::int32_t j) {
            const double b = cloud.radius[std::size_t(j)];
            if ((b < a || (b == a && std::size_t(j) > i)) && cloud.within(i, std::size_t(j), gap))
              insert_once(by_size, int(i), j);
          });
        }
        ASSERT_EQ(by_index, expected);
        ASSERT_EQ(by_size, expected);
      }
}

TEST_P(CellGridOf, NamesEachParticleAtMostOnceHoweverLongTheReach) {
  std::mt19937_64 random(8);
  for (double reach : {0.3, 1.0, 1.5, 4.0, 50.0}) {
    const Cloud cloud = random_cloud(random, GetParam(), 2.0, 60);
    CellGrid grid;
    grid.build(cloud.box, cloud.x, cloud.y, cloud.z, 0.5);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      std::vector<int> seen(cloud.size(), 0);
      grid.for_each_candidate(cloud.position(i), reach, [&](std::int32_t j) { ++seen[std::size_t(j)]; });
      EXPECT_EQ(seen[i], 1);
      for (std::size_t j = 0; j < cloud.size(); ++j) {
        EXPECT_LE(seen[j], 1);
        if (norm(cloud.box.nearest_image(cloud.position(j) - cloud.position(i)).r) < reach) {
          EXPECT_EQ(seen[j], 1);
        }
      }
    }
  }
}

TEST_P(CellGridOf, SearchesNearOnly) {
  std::mt19937_64 random(9);
  const Cloud cloud = random_cloud(random, GetParam(), 30.0, 4000);
  CellGrid grid;
  grid.build(cloud.box, cloud.x, cloud.y, cloud.z, 3.0);
  std::size_t candidates = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    grid.for_each_candidate(cloud.position(i), 3.0, [&](std::int32_t) { ++candidates; });
  const double edge = 3 * 30.0 / 9;  // three cells of at most 30/9
  EXPECT_LT(double(candidates) / 4000, 1.5 * 4000 * edge * edge * edge / cloud.box.volume());
}

TEST_P(CellGridOf, SpatialOrderIsAPermutationThatShortensSteps) {
  std::mt19937_64 random(10);
  const Cloud cloud = random_cloud(random, GetParam(), 10.0, 3000);
  CellGrid grid;
  grid.build(cloud.box, cloud.x, cloud.y, cloud.z, 1.0);
  const std::vector<std::int32_t> order = grid.spatial_order();
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), cloud.size());
  ASSERT_EQ(order.size(), cloud.size());
  double sorted = 0, unsorted = 0;
  for (std::size_t k = 1; k < order.size(); ++k) {
    sorted += norm(cloud.position(std::size_t(order[k])) - cloud.position(std::size_t(order[k - 1])));
    unsorted += norm(cloud.position(k) - cloud.position(k - 1));
  }
  EXPECT_LT(sorted, 0.3 * unsorted);
}

INSTANTIATE_TEST_SUITE_P(AllBoxes, CellGridOf,
                         testing::Values(BoxKind::lees_edwards, BoxKind::periodic, BoxKind::walls));

TEST(CellGrid, AcrossTheShearedFaceItSearchesAtTheShiftedPlace) {
  Box box{BoxKind::lees_edwards, {10, 10, 10}, 1.0, 3.7};
  // The image of particle 1 one box above sits at x + 3.7, just over particle 0.
  const std::vector<double> x{5.0, 1.3}, y{9.8, 0.2}, z{5.0, 5.0};
  CellGrid grid;
  grid.build(box, x, y, z, 1.0);
  std::vector<int> found_from_0, found_from_1;
  grid.for_each_candidate({5.0, 9.8, 5.0}, 1.0, [&](std::int32_t j) { found_from_0.push_back(j); });
  grid.for_each_candidate({1.3, 0.2, 5.0}, 1.0, [&](std::int32_t j) { found_from_1.push_back(j); });
  EXPECT_EQ(std::set<int>(found_from_0.begin(), found_from_0.end()), (std::set<int>{0, 1}));
  EXPECT_EQ(std::set<int>(found_from_1.begin(), found_from_1.end()), (std::set<int>{0, 1}));
}

TEST(CellGrid, NoParticles) {
  CellGrid grid;
  grid.build(Box{}, {}, {}, {}, 0.1);
  grid.for_each_candidate({0.5, 0.5, 0.5}, 1.0, [](std::int32_t) { FAIL(); });
  EXPECT_TRUE(grid.spatial_order().empty());
}

}  // namespace
}  // namespace stresslet
