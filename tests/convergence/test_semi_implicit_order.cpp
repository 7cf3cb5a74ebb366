// The semi-implicit scheme is of first order for many spheres at once: films, sticking contacts, drag and the sheared
// boundary together. No contact opens or closes and no film begins or ends on the way, as the forces of neither are
// smooth there and no order could be expected.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../small_system.hpp"

namespace stresslet {
namespace {

using testing::Sphere;

/// A cubic lattice of edge 1 with radii 0.48 and 0.51 at random: neighbours are 0.04 or 0.01 apart or overlap by 0.02.
Suspension lattice(double step) {
  constexpr int edge = 3;
  std::mt19937 random(5);
  std::vector<Sphere> spheres;
  for (int x = 0; x < edge; ++x)
    for (int y = 0; y < edge; ++y)
      for (int z = 0; z < edge; ++z)
        spheres.push_back({{x + 0.5, y + 0.5, z + 0.5}, random() % 2 ? 0.48 : 0.51, {y + 0.5 - 0.5 * edge, 0, 0}});
  Physics physics;
  physics.drag = true;
  physics.cutoffs = {0.01, 0.2};
  physics.contact.stiffness = 1e3, physics.contact.friction = 100;
  const Box box{BoxKind::lees_edwards, {edge, edge, edge}, 1, 0};
  return testing::small_system(box, spheres, physics, testing::time_control("semi-implicit", step, 1e-10), 0.1, 0.1);
}

/// Which pairs touch, which are joined by a film, by permanent names.
std::vector<std::array<std::int32_t, 3>> bonds(const Suspension& s) {
  std::vector<std::array<std::int32_t, 3>> found;
  for (std::size_t p = 0; p < s.pairs.size(); ++p) {
    const std::int32_t a = s.state.id[std::size_t(s.pairs.i[p])], b = s.state.id[std::size_t(s.pairs.j[p])];
    found.push_back({std::min(a, b), std::max(a, b), s.pairs.gap[p] < 0});
  }
  std::sort(found.begin(), found.end());
  return found;
}

struct Outcome {
  std::vector<Vec3<double>> velocity, spin, place;  // by permanent name
  double contact_stress;
};

Outcome after(double strain, int steps, ThreadTeam& team) {
  Suspension s = lattice(strain / steps);
  start(s, team);
  const auto at_start = bonds(s);
  EXPECT_EQ(s.pairs.size(), 81u);
  for (int n = 0; n < steps; ++n) {
    step(s, team);
    EXPECT_TRUE(bonds(s) == at_start) << "at step " << n;
  }
  const std::size_t count = s.state.size();
  Outcome o{std::vector<Vec3<double>>(count), std::vector<Vec3<double>>(count), std::vector<Vec3<double>>(count),
            sample(s, team).stress.contact.xy};
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t name = std::size_t(s.state.id[i]);
    o.velocity[name] = s.state.velocity(i), o.spin[name] = s.state.angular_velocity(i);
    o.place[name] = s.state.position(i);
  }
  return o;
}

double distance(const std::vector<Vec3<double>>& a, const std::vector<Vec3<double>>& b) {
  double square = 0;
  for (std::size_t k = 0; k < a.size(); ++k) square += dot(a[k] - b[k], a[k] - b[k]);
  return std::sqrt(square);
}

TEST(SemiImplicitOrder, IsOneForManySpheres) {
  constexpr double strain = 0.02;
  ThreadTeam team(1);
  std::vector<Outcome> at;
  for (const int steps : {40, 80, 160, 320}) at.push_back(after(strain, steps, team));
  const auto order = [](double coarse, double fine) { return std::log2(coarse / fine); };
  for (std::size_t k = 0; k + 2 < at.size(); ++k) {
    const auto of = [&](std::vector<Vec3<double>> Outcome::*part) {
      return order(distance(at[k].*part, at[k + 1].*part), distance(at[k + 1].*part, at[k + 2].*part));
    };
    EXPECT_NEAR(of(&Outcome::velocity), 1, 0.1);
    EXPECT_NEAR(of(&Outcome::spin), 1, 0.1);
    EXPECT_NEAR(of(&Outcome::place), 1, 0.1);
    EXPECT_NEAR(
        order(at[k].contact_stress - at[k + 1].contact_stress, at[k + 1].contact_stress - at[k + 2].contact_stress), 1,
        0.1);
  }
}

}  // namespace
}  // namespace stresslet
