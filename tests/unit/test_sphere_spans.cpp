// Rows and spans of a sphere against a search of all cells.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "../random_pairs.hpp"
#include "stresslet/coupling/spans.hpp"

namespace stresslet {
namespace {

using testing::Draw;

/// Squared distance from `c` to the nearest point of the cell minus R^2, and to the farthest point minus r^2.
struct Margins {
  double touch, full;
};
Margins margins(int x, int y, int z, const Vec3<double>& c, double touch_radius, double full_radius) {
  const double d[] = {std::abs(x - c.x), std::abs(y - c.y), std::abs(z - c.z)};
  Margins m{-touch_radius * touch_radius, -full_radius * full_radius};
  for (const double a : d) {
    const double nearest = a > 0.5 ? a - 0.5 : 0;
    m.touch += nearest * nearest;
    m.full += (a + 0.5) * (a + 0.5);
  }
  return m;
}

void compare(const Vec3<double>& c, double touch_radius, double full_radius) {
  std::map<std::pair<int, int>, RowSpan> rows;
  for_each_row_of_sphere(c, touch_radius, full_radius, [&](const RowSpan& row) {
    EXPECT_TRUE(rows.emplace(std::pair{row.z, row.y}, row).second) << "row twice";
    EXPECT_LT(row.touched.begin, row.touched.end);
    EXPECT_LE(row.touched.begin, row.full.begin);
    EXPECT_LE(row.full.begin, row.full.end);
    EXPECT_LE(row.full.end, row.touched.end);
  });
  const double undecided = 1e-12 * (1 + touch_radius * touch_radius);
  const int reach = int(std::ceil(touch_radius)) + 2;
  const auto around = [&](double centre, auto&& body) {
    for (int k = int(std::floor(centre)) - reach; k <= int(std::ceil(centre)) + reach; ++k) body(k);
  };
  long cells = 0, counted = 0;
  around(c.z, [&](int z) {
    around(c.y, [&](int y) {
      const auto row = rows.find({z, y});
      around(c.x, [&](int x) {
        const bool touched = row != rows.end() && x >= row->second.touched.begin && x < row->second.touched.end;
        const bool full = row != rows.end() && x >= row->second.full.begin && x < row->second.full.end;
        counted += touched;
        const Margins m = margins(x, y, z, c, touch_radius, full_radius);
        EXPECT_TRUE(touched == (m.touch < 0) || std::abs(m.touch) < undecided) << x << ' ' << y << ' ' << z;
        EXPECT_TRUE(full == (m.full < 0) || std::abs(m.full) < undecided) << x << ' ' << y << ' ' << z;
      });
    });
  });
  for (const auto& [place, row] : rows) cells += row.touched.size();
  EXPECT_EQ(cells, counted);  // no cell beyond the search
}

TEST(SphereSpans, EqualASearchOfAllCells) {
  Draw draw(1);
  for (int n = 0; n < 300; ++n) {
    const double touch = draw.log_uniform(0.05, 12), full = touch * draw.uniform(0.5, 1);
    compare({draw.uniform(-20, 20), draw.uniform(-20, 20), draw.uniform(-20, 20)}, touch, n % 2 ? touch : full);
  }
}

TEST(SphereSpans, HoldOnTheGridAndHalfWay) {
  for (const double r : {0.2, 0.5, 1.0, 1.5, 2.0, 5.0, 5.5})
    for (const Vec3<double>& c : {Vec3<double>{0, 0, 0}, {0.5, 0.5, 0.5}, {3, -7.5, 2}, {-1, 4, 0.5}}) compare(c, r, r);
}

TEST(SphereSpans, VisitRowsInOrder) {
  std::pair<int, int> last{-1000, -1000};
  for_each_row_of_sphere({0.3, -0.2, 7.1}, 4.2, 4.2, [&](const RowSpan& row) {
    const std::pair place{row.z, row.y};
    EXPECT_LT(last, place);
    last = place;
  });
}

TEST(SphereSpans, MoveWithTheSphere) {
  std::vector<int> here, there;
  const auto list = [](std::vector<int>& to, int dx, int dy, int dz) {
    return [&to, dx, dy, dz](const RowSpan& r) {
      to.insert(to.end(),
                {r.y - dy, r.z - dz, r.touched.begin - dx, r.touched.end - dx, r.full.begin - dx, r.full.end - dx});
    };
  };
  for_each_row_of_sphere({0.25, 0.5, -0.125}, 3.5, 3.25, list(here, 0, 0, 0));
  for_each_row_of_sphere({64.25, -31.5, 15.875}, 3.5, 3.25, list(there, 64, -32, 16));
  EXPECT_EQ(here, there);
}

}  // namespace
}  // namespace stresslet
