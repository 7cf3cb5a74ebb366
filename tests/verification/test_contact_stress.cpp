// Stress of contacts that are known: sigma = (1/V) sum r F, tension positive.
#include <gtest/gtest.h>

#include <cmath>

#include "../random_pairs.hpp"
#include "../small_system.hpp"

namespace stresslet {
namespace {

using testing::Draw;
using testing::Sphere;

void expect_near(const Stress& found, const Stress& expected, double tolerance) {
  EXPECT_NEAR(found.xx, expected.xx, tolerance);
  EXPECT_NEAR(found.yy, expected.yy, tolerance);
  EXPECT_NEAR(found.zz, expected.zz, tolerance);
  EXPECT_NEAR(found.xy, expected.xy, tolerance);
  EXPECT_NEAR(found.xz, expected.xz, tolerance);
  EXPECT_NEAR(found.yz, expected.yz, tolerance);
}

ContactParameters springs(double stiffness) {
  ContactParameters c;
  c.stiffness = stiffness;
  return c;
}

Sample sample_at_rest(const Box& box, const std::vector<Sphere>& spheres, double stiffness) {
  ThreadTeam team(1);
  Suspension s = testing::small_system(box, spheres, testing::dry(springs(stiffness)),
                                       testing::time_control("explicit", 1e-9), 1.0);
  start(s, team);
  return sample(s, team);
}

TEST(ContactStress, OfOnePairIsSeparationTimesForceOverVolume) {
  Draw draw(11);
  const double stiffness = 50, a1 = 0.4, a2 = 0.7, overlap = 0.02, distance = a1 + a2 - overlap;
  const Box box{BoxKind::periodic, {6, 7, 8}, 0, 0};
  for (int n = 0; n < 50; ++n) {
    const Vec3<double> e = draw.direction(), middle{3, 3.5, 4};
    const Sample found =
        sample_at_rest(box, {{middle - 0.5 * distance * e, a1}, {middle + 0.5 * distance * e, a2}}, stiffness);
    const Stress expected = (-stiffness * overlap * distance / (6 * 7 * 8)) * square(e);
    expect_near(found.stress.contact, expected, 1e-13 * stiffness * overlap);
    expect_near(found.stress.total(), expected, 1e-12 * stiffness * overlap);
    EXPECT_EQ(found.contacts, 1);
    EXPECT_NEAR(found.largest_overlap, overlap / (2 * a1), 1e-13);
    EXPECT_NEAR(found.elastic_energy, 0.5 * stiffness * overlap * overlap / (6 * 7 * 8), 1e-15);
  }
}

TEST(ContactStress, OfACompressedFaceCentredLatticeIsAPressure) {
  const double stiffness = 1000, overlap = 0.01, distance = 1 - overlap, edge = std::sqrt(2.0) * distance;
  constexpr int cells = 3;
  const Box box{BoxKind::lees_edwards, {cells * edge, cells * edge, cells * edge}, 0, 0};
  std::vector<Sphere> spheres;
  for (int x = 0; x < cells; ++x)
    for (int y = 0; y < cells; ++y)
      for (int z = 0; z < cells; ++z)
        for (const auto& b : {Vec3<double>{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}})
          spheres.push_back({edge * (Vec3<double>{double(x), double(y), double(z)} + b), 0.5});
  const Sample found = sample_at_rest(box, spheres, stiffness);
  // Twelve contacts a sphere, each counted once; four spheres a cell.
  const double pressure = 4 * 6 * distance * stiffness * overlap / (3 * std::pow(edge, 3));
  EXPECT_EQ(found.contacts, double(6 * spheres.size()));
  expect_near(found.stress.contact, -pressure * identity3<double>(), 1e-11 * pressure);
}

// Rock salt of large and small spheres, touching only where they differ; cells stretched along z, so contacts differ.
TEST(ContactStress, OfUnequalContactsDiffersByDirection) {
  const double stiffness = 300, large = 0.6, small = 0.4, tight = 0.97, loose = 0.99;
  constexpr int sites = 6;
  const Box box{BoxKind::periodic, {sites * tight, sites * tight, sites * loose}, 0, 0};
  std::vector<Sphere> spheres;
  for (int x = 0; x < sites; ++x)
    for (int y = 0; y < sites; ++y)
      for (int z = 0; z < sites; ++z)
        spheres.push_back({{tight * x, tight * y, loose * z}, (x + y + z) % 2 ? small : large});
  const Sample found = sample_at_rest(box, spheres, stiffness);
  const double volume_per_site = tight * tight * loose;
  const double across = stiffness * (large + small - tight) * tight / volume_per_site,
               along = stiffness * (large + small - loose) * loose / volume_per_site;
  EXPECT_EQ(found.contacts, double(3 * spheres.size()));
  expect_near(found.stress.contact, {-across, -across, -along, 0, 0, 0}, 1e-11 * across);
}

}  // namespace
}  // namespace stresslet
