// Solid fractions against closed forms: caps, octants, columns, cut corners, the volume of the sphere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../random_pairs.hpp"
#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/laws.hpp"

namespace stresslet {
namespace {

using testing::Draw;

double sphere_volume(double r) { return 4 * pi / 3 * r * r * r; }
double cap_volume(double r, double height) { return pi * height * height * (3 * r - height) / 3; }

/// Sum of the fractions of all cells around a sphere, cells centred on integers.
template <class Law>
double total(const Law& law, const Vec3<double>& centre, double radius) {
  const auto low = [&](double c) { return int(std::floor(c - radius - 1)); };
  const auto high = [&](double c) { return int(std::ceil(c + radius + 1)); };
  double sum = 0;
  for (int z = low(centre.z); z <= high(centre.z); ++z)
    for (int y = low(centre.y); y <= high(centre.y); ++y)
      for (int x = low(centre.x); x <= high(centre.x); ++x)
        sum += law.fraction(Vec3<double>{x - centre.x, y - centre.y, z - centre.z}, radius);
  return sum;
}

Vec3<double> in_cell(Draw& draw) { return {draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(0, 1)}; }

/// A cell near the surface of a sphere.
struct Shell {
  Vec3<double> offset;
  double radius;
};
Shell draw_shell(Draw& draw) {
  Shell s;
  s.radius = draw.log_uniform(1.5, 30);
  s.offset = (s.radius + draw.uniform(-1, 1)) * draw.direction();
  return s;
}

TEST(ExactOverlap, IsTheSphereWhereTheCubeHoldsIt) {
  for (const double r : {0.01, 0.2, 0.4}) {
    EXPECT_NEAR(sphere_cube_overlap({0, 0, 0}, r), sphere_volume(r), 1e-14);
    EXPECT_NEAR(sphere_cube_overlap({0.1, -0.05, 0.08}, r), sphere_volume(r), 1e-14);
  }
}

TEST(ExactOverlap, IsAnOctantAboutACorner) {
  for (const double r : {0.1, 0.5, 0.9, 1.0})
    for (const double sx : {-1, 1})
      for (const double sy : {-1, 1})
        for (const double sz : {-1, 1})
          EXPECT_NEAR(sphere_cube_overlap({0.5 * sx, 0.5 * sy, 0.5 * sz}, r), sphere_volume(r) / 8, 1e-14);
}

TEST(ExactOverlap, IsACapThroughOneFace) {
  Draw draw(1);
  for (int n = 0; n < 200; ++n) {
    const double r = draw.log_uniform(0.5, 40), height = draw.uniform(0, 1) * 0.1 / (2 * r);  // rim radius below 0.32
    const double a = draw.uniform(-0.15, 0.15), b = draw.uniform(-0.15, 0.15), along = r - height + 0.5;
    const double cap = cap_volume(r, height);
    for (const Vec3<double>& offset : {Vec3<double>{along, a, b}, {a, -along, b}, {a, b, along}})
      EXPECT_NEAR(sphere_cube_overlap(offset, r), cap, 1e-13) << r << ' ' << height;
  }
}

TEST(ExactOverlap, LosesSixCapsAndTwelveWedgesAboutTheCentre) {
  for (const double r : {0.5, 0.55, 0.6, 0.7})
    EXPECT_NEAR(sphere_cube_overlap({0, 0, 0}, r), sphere_volume(r) - 6 * cap_volume(r, r - 0.5), 1e-14);
  for (const double r : {0.87, 0.9, 3.0}) EXPECT_EQ(sphere_cube_overlap({0, 0, 0}, r), 1);
}

// Volume of a sphere over the unit square about its axis, from the equator: Jones & Williams (2017); here as
// integral of sqrt(r^2 - x^2 - y^2), in closed form.
TEST(ExactOverlap, AddsUpToTheColumnOverASquare) {
  for (const double r : {1.5, 5.0, 7.3, 20.0}) {
    const double s = std::sqrt(r * r - 0.5), q = r * r;
    const double column = s / 3 + (2 * q - 1.0 / 6) * std::atan(0.5 / s) - 4.0 / 3 * q * r * std::atan(0.25 / (r * s));
    double sum = 0;
    for (int k = 0; k < r + 1; ++k) sum += sphere_cube_overlap({0, 0, k + 0.5}, r);
    EXPECT_NEAR(sum, column, 1e-12);
  }
}

TEST(ExactOverlap, AddsUpToTheSphere) {
  Draw draw(2);
  for (const double r : {0.3, 0.8, 1.5, 2.7, 5.0, 7.1})
    for (int n = 0; n < 3; ++n) {
      const Vec3<double> centre = n == 0 ? Vec3<double>{0, 0, 0} : in_cell(draw);
      EXPECT_NEAR(total(ExactOverlap{}, centre, r), sphere_volume(r), 1e-13 * (10 + r * r)) << r;
    }
}

/// By inclusion and exclusion of corners, in extended precision: exact, but it cancels for small components.
double cut_by_corners(const Vec3<double>& n, double distance) {
  const long double m[] = {std::abs(n.x), std::abs(n.y), std::abs(n.z)};
  const long double t = distance + (m[0] + m[1] + m[2]) / 2;
  long double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    long double left = t;
    int sign = 1;
    for (int a = 0; a < 3; ++a)
      if (corner >> a & 1) left -= m[a], sign = -sign;
    if (left > 0) sum += sign * left * left * left;
  }
  return double(sum / (6 * m[0] * m[1] * m[2]));
}

TEST(PlaneCut, EqualsInclusionAndExclusionOfCorners) {
  Draw draw(3);
  for (int n = 0; n < 20000; ++n) {
    const Vec3<double> normal = draw.direction();
    const double smallest = std::min({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    const double middle = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z) - smallest -
                          std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    const double distance = draw.uniform(-1, 1);
    EXPECT_NEAR(plane_cut_of_unit_cube(normal, distance), cut_by_corners(normal, distance),
                1e-15 + 1e-18 / (smallest * middle))
        << normal.x << ' ' << normal.y << ' ' << normal.z << ' ' << distance;
  }
}

TEST(PlaneCut, HasItsLimitsAlongTheGrid) {
  const double c = std::sqrt(0.5);
  // A tilt changes the fraction by at most a quarter of it: |d fraction / d n_k| <= mean |xi_k| at a face of the cube.
  for (const double tilt : {0.0, 1e-300, 1e-160, 1e-17, 1e-12, 1e-8, 1e-5}) {
    const double allowed = 1e-15 + 0.25 * tilt;
    for (double d = -0.7; d <= 0.7; d += 0.0125) {
      const double slab = std::clamp(0.5 + d, 0.0, 1.0);
      EXPECT_NEAR(plane_cut_of_unit_cube<double>({1, tilt, 0}, d), slab, allowed);
      EXPECT_NEAR(plane_cut_of_unit_cube<double>({0.5 * tilt, 1, 0.5 * tilt}, d), slab, allowed);
      EXPECT_NEAR(plane_cut_of_unit_cube<double>({-1e-3 * tilt, tilt, -1}, d), slab, 1.01 * allowed);
      const double below = std::max(c - std::abs(d), 0.0), wedge = d < 0 ? below * below : 1 - below * below;
      EXPECT_NEAR(plane_cut_of_unit_cube<double>({c, -c, tilt}, d), wedge, allowed);
    }
  }
}

TEST(PlaneCut, AboutTheCentreIsFull) {
  EXPECT_EQ(PlaneCut{}.fraction(Vec3<double>{0, 0, 0}, 2.0), 1);
  EXPECT_EQ(PlaneCut{}.fraction(Vec3<double>{1e-200, 0, 1e-160}, 2.0), 1);
}

/// Mean of `total` over positions of the sphere: the sum over a grid `fine` times finer, divided.
template <class Law>
double mean_total(const Law& law, double radius, int fine) {
  double sum = 0;
  const int reach = int(std::ceil((radius + 1) * fine));
  for (int z = -reach; z <= reach; ++z)
    for (int y = -reach; y <= reach; ++y)
      for (int x = -reach; x <= reach; ++x)
        sum += law.fraction(Vec3<double>{double(x) / fine, double(y) / fine, double(z) / fine}, radius);
  return sum / (fine * fine * fine);
}

// 4 pi/3 (r^3 - 1/(1728 r^3)) for both; the remaining difference is that of the sum from the integral over positions.
TEST(CurvatureCorrection, MakesTheMeanVolumeRight) {
  for (const double r : {1.0, 1.25, 2.0}) {
    const double expected = 4 * pi / 3 * (r * r * r - 1 / (1728 * r * r * r));
    EXPECT_NEAR(mean_total(PlaneCut{}, r, 16), expected, 2e-6 * expected) << r;
    EXPECT_NEAR(mean_total(DistanceWeighting{}, r, 16), expected, 2e-4 * expected) << r;
  }
}

/// Largest relative error of the sphere's volume over special and random positions.
template <class Law>
double volume_error(const Law& law, double radius) {
  Draw draw(5);
  double worst = 0;
  for (int n = 0; n < 20; ++n) {
    const Vec3<double> special[] = {{0, 0, 0}, {0.5, 0.5, 0.5}, {0.5, 0, 0}};
    const double sum = total(law, n < 3 ? special[n] : in_cell(draw), radius);
    worst = std::max(worst, std::abs(sum / sphere_volume(radius) - 1));
  }
  return worst;
}

TEST(SolidFraction, AddsUpToTheSphereAtAnyPosition) {
  for (const double r : {1.0, 1.5, 2.5, 4.0, 5.0, 7.0, 10.3}) {
    EXPECT_LT(volume_error(PlaneCut{}, r), 0.1 / (r * r * r)) << r;
    EXPECT_LT(volume_error(DistanceWeighting{}, r), 0.25 / (r * r)) << r;
    EXPECT_LT(volume_error(SubCells{}, r), 0.04 / (r * r)) << r;
  }
}

TEST(SolidFraction, OfOneCellIsNearTheExactOne) {
  Draw draw(6);
  for (int n = 0; n < 1500; ++n) {
    Shell s = draw_shell(draw);
    if (n % 4 == 0) s.offset = {norm(s.offset), 0.2 * s.offset.y / s.radius, 0};  // surface nearly along the grid
    const double exact = sphere_cube_overlap(s.offset, s.radius);
    EXPECT_NEAR(PlaneCut{}.fraction(s.offset, s.radius), exact, 0.06 / s.radius);
    EXPECT_NEAR(DistanceWeighting{}.fraction(s.offset, s.radius), exact, 0.048 + 0.06 / s.radius);
    for (const int per_direction : {3, 10, 30})
      EXPECT_NEAR(SubCells{per_direction}.fraction(s.offset, s.radius), exact, 0.51 / per_direction);
  }
}

}  // namespace
}  // namespace stresslet
