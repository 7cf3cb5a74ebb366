#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "stresslet/base/error.hpp"
#include "stresslet/particles/packing/generator.hpp"
#include "stresslet/particles/packing/random_close_packing.hpp"
#include "stresslet/particles/sizes/laws.hpp"

namespace stresslet {
namespace {

using testing::HasSubstr;

std::vector<SizeClassed> mixture(std::size_t count) { return Discrete::sizes({{1, 1.4}, {}, {1, 1}}, count); }

PackingRequest request(BoxKind kind, double solid_fraction, std::uint64_t seed = 1) {
  PackingRequest r;
  r.kind = kind, r.solid_fraction = solid_fraction, r.seed = seed;
  return r;
}

/// Smallest surface-to-surface gap, by all pairs and all neighbouring images.
double smallest_gap(const Packing& packing) {
  const ParticleState& s = packing.state;
  const Box& box = packing.box;
  double smallest = std::numeric_limits<double>::max();
  const auto axis = [](double d, double length) { return std::min(std::abs(d), length - std::abs(d)); };
  for (std::size_t i = 0; i < s.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const double dx = axis(s.x[i] - s.x[j], box.length.x), dz = axis(s.z[i] - s.z[j], box.length.z);
      const double dy = box.periodic_in_y() ? axis(s.y[i] - s.y[j], box.length.y) : s.y[i] - s.y[j];
      smallest = std::min(smallest, std::sqrt(dx * dx + dy * dy + dz * dz) - s.radius[i] - s.radius[j]);
    }
    if (!box.periodic_in_y())
      smallest = std::min({smallest, s.y[i] - s.radius[i], box.length.y - s.radius[i] - s.y[i]});
  }
  return smallest;
}

double solid_fraction_of(const Packing& packing) {
  double volume = 0;
  for (const double a : packing.state.radius) volume += 4.0 / 3.0 * pi * std::pow(a, 3);
  return volume / (packing.box.length.x * packing.box.length.y * packing.box.length.z);
}

void expect_inside(const Packing& packing) {
  const ParticleState& s = packing.state;
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_TRUE(s.x[i] >= 0 && s.x[i] < packing.box.length.x);
    EXPECT_TRUE(s.y[i] >= 0 && s.y[i] < packing.box.length.y);
    EXPECT_TRUE(s.z[i] >= 0 && s.z[i] < packing.box.length.z);
  }
}

class PackingOf : public testing::TestWithParam<std::tuple<BoxKind, double>> {};

TEST_P(PackingOf, HasTheSolidFractionAndNoOverlap) {
  const auto [kind, solid_fraction] = GetParam();
  const Packing packing = generate_packing(mixture(500), request(kind, solid_fraction));
  EXPECT_EQ(packing.box.kind, kind);
  EXPECT_NEAR(solid_fraction_of(packing), solid_fraction, 1e-12);
  EXPECT_GT(smallest_gap(packing), 1e-5);
  expect_inside(packing);
}

INSTANTIATE_TEST_SUITE_P(AllBoxes, PackingOf,
                         testing::Combine(testing::Values(BoxKind::lees_edwards, BoxKind::periodic, BoxKind::walls),
                                          testing::Values(0.05, 0.5, 0.6)));

TEST(Packing, ReachesTheDensestMixtureOfTheLiterature) {
  for (std::uint64_t seed : {1u, 2u}) {
    const Packing packing = generate_packing(mixture(500), request(BoxKind::lees_edwards, 0.64, seed));
    EXPECT_NEAR(solid_fraction_of(packing), 0.64, 1e-12);
    EXPECT_GT(smallest_gap(packing), 1e-5);
  }
}

TEST(Packing, WideSizeDistributions) {
  for (const auto& sizes : {Lognormal::sizes({1, 0.5, 0.3, 3}, 600), Discrete::sizes({{1, 5}, {}, {1, 1}}, 1200)}) {
    const Packing packing = generate_packing(sizes, request(BoxKind::periodic, 0.6));
    EXPECT_GT(smallest_gap(packing), 1e-6);
    for (std::size_t i = 0; i < sizes.size(); ++i) {
      EXPECT_EQ(packing.state.radius[i], 0.5 * sizes[i].diameter);
      EXPECT_EQ(packing.state.species[i], sizes[i].species);
      EXPECT_EQ(packing.state.id[i], std::int32_t(i));
    }
  }
}

TEST(Packing, AspectSetsTheRatiosOfTheBox) {
  PackingRequest r = request(BoxKind::lees_edwards, 0.4);
  r.aspect = {2, 1, 0.5};
  const Packing packing = generate_packing(mixture(400), r);
  EXPECT_NEAR(packing.box.length.x / packing.box.length.y, 2, 1e-13);
  EXPECT_NEAR(packing.box.length.z / packing.box.length.y, 0.5, 1e-13);
  EXPECT_GT(smallest_gap(packing), 1e-5);
}

TEST(Packing, ParticlesMoveWithTheMeanFlow) {
  PackingRequest r = request(BoxKind::lees_edwards, 0.3);
  r.shear_rate = 2, r.density = 0.1;
  const Packing packing = generate_packing(mixture(100), r);
  const ParticleState& s = packing.state;
  for (std::size_t i = 0; i < s.size(); ++i) {
    EXPECT_DOUBLE_EQ(s.ux[i], 2 * (s.y[i] - 0.5 * packing.box.length.y));
    EXPECT_EQ(s.uy[i], 0);
    EXPECT_EQ(s.uz[i], 0);
    EXPECT_EQ(s.angular_velocity(i), (Vec3<double>{0, 0, -1}));
    EXPECT_EQ(s.density[i], 0.1);
  }
  r.kind = BoxKind::periodic;
  EXPECT_EQ(generate_packing(mixture(100), r).state.velocity(7), (Vec3<double>{0, 0, 0}));
}

TEST(Packing, SeedDecidesEveryBit) {
  const auto positions = [](std::uint64_t seed) {
    return generate_packing(mixture(300), request(BoxKind::lees_edwards, 0.6, seed)).state.x;
  };
  EXPECT_EQ(positions(3), positions(3));
  EXPECT_NE(positions(3), positions(4));
}

/// Chi-squared of the centres' counts in ten slabs over ten starts: 9 on average for independent points, less for
/// dense spheres, which spread more evenly; far more if density followed the faces of the box.
TEST(Packing, DensityIsTheSameAcrossTheBox) {
  std::vector<double> count(10, 0);
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Packing packing = generate_packing(mixture(200), request(BoxKind::lees_edwards, 0.5, seed));
    for (const double y : packing.state.y) count[std::size_t(10 * y / packing.box.length.y)] += 1;
  }
  double chi_squared = 0;
  for (const double n : count) {
    EXPECT_NEAR(n, 200, 4 * std::sqrt(200));
    chi_squared += (n - 200) * (n - 200) / 200;
  }
  EXPECT_LT(chi_squared, 27.9);  // exceeded once in a thousand by independent points
}

/// Pairs within 2 % of contact against the contact value of the hard-sphere fluid, g = (1 - phi/2)/(1 - phi)^3
/// (Carnahan & Starling 1969), from which g(r) falls by 3 % (phi = 0.3) to 8 % (phi = 0.5) on average over the shell.
TEST(Packing, AgitatedLongPairsNearContactAreThoseOfTheHardSphereFluid) {
  const double shell = 0.02;
  const int starts = 4;
  const std::size_t count = 500;
  for (double solid_fraction : {0.3, 0.5}) {
    double pairs = 0;
    for (std::uint64_t seed = 1; seed <= starts; ++seed) {
      PackingRequest long_agitated = request(BoxKind::periodic, solid_fraction, seed);
      long_agitated.sweeps = 800;
      const Packing packing = generate_packing(Monodisperse::sizes({1}, count), long_agitated);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
          pairs += norm(packing.box.nearest_image(packing.state.position(i) - packing.state.position(j)).r) < 1 + shell;
    }
    const double contact_value = (1 - 0.5 * solid_fraction) / std::pow(1 - solid_fraction, 3);
    const double number_density = solid_fraction / (pi / 6);
    const double shell_volume = 4.0 / 3.0 * pi * (std::pow(1 + shell, 3) - 1);
    const double per_g = starts * 0.5 * double(count) * number_density * shell_volume;
    EXPECT_GT(pairs / per_g, 0.82 * contact_value) << solid_fraction;
    EXPECT_LT(pairs / per_g, 1.12 * contact_value) << solid_fraction;
  }
}

TEST(Packing, ReportsAscendingProgress) {
  std::vector<double> parts;
  generate_packing(mixture(300), request(BoxKind::lees_edwards, 0.62), [&](double part) { parts.push_back(part); });
  EXPECT_GE(parts.size(), 3u);
  EXPECT_EQ(parts.front(), 0);
  EXPECT_EQ(parts.back(), 1);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
}

std::string refusal(const std::vector<SizeClassed>& sizes, const PackingRequest& r) {
  try {
    generate_packing(sizes, r);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Packing, RefusesSolidFractionsBeyondReach) {
  EXPECT_THAT(refusal(mixture(1000), request(BoxKind::lees_edwards, 0.8)),
              testing::AllOf(HasSubstr("0.8"), HasSubstr("0.647"), HasSubstr("random close packing")));
  // Just above random close packing it tries, and says how far it came.
  const std::string tried = refusal(Monodisperse::sizes({1}, 200), request(BoxKind::lees_edwards, 0.658));
  EXPECT_THAT(tried,
              testing::AllOf(HasSubstr("0.658"), HasSubstr("the closest packing found has 0.6"), HasSubstr("0.634")));
}

TEST(Packing, RefusesWrongParameters) {
  const auto kind = BoxKind::lees_edwards;
  for (double phi : {0.0, -0.1, 1.0, std::nan("")})
    EXPECT_THAT(refusal(mixture(100), request(kind, phi)), HasSubstr("solid fraction"));
  EXPECT_THAT(refusal({}, request(kind, 0.3)), HasSubstr("no particles"));
  EXPECT_THAT(refusal({{-1, 0}}, request(kind, 0.3)), HasSubstr("diameter -1"));
  EXPECT_THAT(refusal(mixture(10), request(kind, 0.5)), HasSubstr("its own image"));
  PackingRequest r = request(kind, 0.3);
  r.aspect.y = 0;
  EXPECT_THAT(refusal(mixture(100), r), HasSubstr("aspect"));
  r = request(kind, 0.3);
  r.density = -1;
  EXPECT_THAT(refusal(mixture(100), r), HasSubstr("density"));
}

/// Polydispersity and skewness of two sizes with number fractions p, 1 - p in closed form.
TEST(RandomClosePacking, OfMixturesFromClosedForms) {
  EXPECT_NEAR(random_close_packing({1, 1, 1}), 0.634, 1e-12);
  EXPECT_NEAR(random_close_packing({2, 4}), 0.634 + 0.0658 / 3, 1e-12);  // no skewness
  const double p = 0.75, mean = 1 * p + 2 * (1 - p);
  const double delta = std::sqrt(p * (1 - p)) / mean, skewness = (2 * p - 1) / std::sqrt(p * (1 - p));
  EXPECT_NEAR(random_close_packing({1, 1, 1, 2}), 0.634 + 0.0658 * delta + 0.0857 * skewness * delta * delta, 1e-12);
}

}  // namespace
}  // namespace stresslet
