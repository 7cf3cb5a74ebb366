// Every law in SolidFractionLaws: limits, symmetry, monotony, packs, and the radii that bound its cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../random_pairs.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/spans.hpp"

namespace stresslet {
namespace {

using testing::Draw;

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

/// A cell near the surface of a sphere.
struct Shell {
  Vec3<double> offset;
  double radius;
};
Shell draw_shell(Draw& draw) {
  Shell s;
  s.radius = draw.log_uniform(1, 30);
  s.offset = (s.radius + draw.uniform(-1, 1)) * draw.direction();
  return s;
}

template <class Law>
class SolidFractionLaw : public ::testing::Test {
 public:
  Law law;
};
TYPED_TEST_SUITE(SolidFractionLaw, GTestTypes<SolidFractionLaws>::type);

TYPED_TEST(SolidFractionLaw, IsZeroOutsideAndOneInside) {
  Draw draw(1);
  for (int n = 0; n < 200; ++n) {
    const double r = draw.log_uniform(1, 30), half_diagonal = std::sqrt(0.75);
    const Vec3<double> e = draw.direction();
    EXPECT_EQ(this->law.fraction((r + half_diagonal + 1e-9) * e, r), 0);
    EXPECT_EQ(this->law.fraction((r + 3) * e, r), 0);
    const double within = std::max(r - half_diagonal - 1 / (12 * r), 0.0);
    EXPECT_NEAR(this->law.fraction((draw.uniform(0, 1) * within) * e, r), 1, 1e-13);
  }
  EXPECT_NEAR(this->law.fraction(Vec3<double>{0, 0, 0}, 2.0), 1, 1e-13);
}

TYPED_TEST(SolidFractionLaw, StaysWithinItsBounds) {
  Draw draw(2);
  for (int n = 0; n < 1000; ++n) {
    const Shell s = draw_shell(draw);
    const double fraction = this->law.fraction(s.offset, s.radius);
    EXPECT_GE(fraction, 0);
    EXPECT_LE(fraction, 1 + 1e-13);
  }
}

TYPED_TEST(SolidFractionLaw, GrowsWithTheRadius) {
  Draw draw(3);
  for (int n = 0; n < 200; ++n) {
    const Shell s = draw_shell(draw);
    double last = 0;
    for (double r = std::max(s.radius - 1, 1.0); r < s.radius + 1; r += 0.1) {
      const double fraction = this->law.fraction(s.offset, r);
      EXPECT_GE(fraction, last - 1e-13);
      last = fraction;
    }
  }
}

TYPED_TEST(SolidFractionLaw, IsTheSameForMirrorImagesAndTurnsOfTheGrid) {
  Draw draw(4);
  for (int n = 0; n < 100; ++n) {
    const Shell s = draw_shell(draw);
    const auto& [x, y, z] = s.offset;
    const double fraction = this->law.fraction(s.offset, s.radius);
    for (const Vec3<double>& image :
         {Vec3<double>{-x, y, z}, {x, -y, z}, {x, y, -z}, {-x, -y, -z}, {y, x, z}, {z, x, y}, {x, z, y}, {-z, y, -x}})
      EXPECT_NEAR(this->law.fraction(image, s.radius), fraction, 2e-14 * s.radius);
  }
}

TYPED_TEST(SolidFractionLaw, GivesThePackWhatItGivesTheCell) {
  Draw draw(5);
  for (int n = 0; n < 100; ++n) {
    const double radius = draw.log_uniform(1, 30);
    const Vec3<double> first = (radius + draw.uniform(-1, 1)) * draw.direction();
    const Pack lane([](auto k) { return double(k); });
    const Vec3<Pack> offset{first.x + lane, Pack(first.y), Pack(first.z)};
    const Pack fraction = this->law.fraction(offset, Pack(radius));
    for (std::size_t k = 0; k < pack_width; ++k) {
      const double alone = this->law.fraction(Vec3<double>{first.x + double(k), first.y, first.z}, radius);
      EXPECT_NEAR(fraction[k], alone, 4e-15 * radius);
    }
  }
}

TYPED_TEST(SolidFractionLaw, HasItsCellsWithinItsSpans) {
  Draw draw(6);
  for (const double radius : {1.0, 1.4, 2.5, 5.0, 7.2})
    for (int n = 0; n < 4; ++n) {
      const Vec3<double> c =
          n == 0 ? Vec3<double>{0, 0, 0} : Vec3<double>{draw.uniform(-9, 9), draw.uniform(-9, 9), draw.uniform(-9, 9)};
      const auto fraction = [&](int x, int y, int z) {
        return this->law.fraction(Vec3<double>{x - c.x, y - c.y, z - c.z}, radius);
      };
      double in_spans = 0, everywhere = 0;
      for_each_row_of_sphere(c, TypeParam::touch_radius(radius), TypeParam::full_radius(radius),
                             [&](const RowSpan& row) {
                               for (int x = row.touched.begin; x < row.touched.end; ++x)
                                 in_spans += fraction(x, row.y, row.z);
                               for (int x = row.full.begin; x < row.full.end; ++x)
                                 EXPECT_NEAR(fraction(x, row.y, row.z), 1, 1e-13);
                             });
      const int reach = int(radius) + 3;
      for (int z = int(c.z) - reach; z <= int(c.z) + reach; ++z)
        for (int y = int(c.y) - reach; y <= int(c.y) + reach; ++y)
          for (int x = int(c.x) - reach; x <= int(c.x) + reach; ++x) everywhere += fraction(x, y, z);
      EXPECT_NEAR(in_spans, everywhere, 1e-11);
    }
}

}  // namespace
}  // namespace stresslet
