// Every law in CollisionLaws on every stencil: conservation, equilibrium, viscosity, symmetry of the lattice.
#include <gtest/gtest.h>

#include <algorithm>

#include "../small_fluid.hpp"
#include "linear_lattice.hpp"
#include "random_populations.hpp"
#include "stresslet/lattice/cell_state.hpp"

namespace stresslet {
namespace {

using namespace testing;

template <class List>
struct GTestTypes;
template <class... Laws>
struct GTestTypes<TypeList<Laws...>> {
  using type = ::testing::Types<Laws...>;
};

template <class Law>
class CollisionLaw : public ::testing::Test {
 protected:
  std::mt19937 engine{11};
};
TYPED_TEST_SUITE(CollisionLaw, GTestTypes<CollisionLaws>::type);

/// All rates of their own, where the law has them.
CollisionInput input_of(double relaxation_time) { return {relaxation_time, 0.13, 1.3, 0.7}; }

TYPED_TEST(CollisionLaw, ConservesMassAndMomentum) {
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    for (const double tau : relaxation_times)
      for (int n = 0; n < 50; ++n) {
        const auto before = random_populations<Stencil>(this->engine);
        const auto after = collided<TypeParam, NoForce, Stencil>(before, input_of(tau));
        EXPECT_NEAR(mass<Stencil>(after), mass<Stencil>(before), 1e-16);
        EXPECT_LT(norm(momentum<Stencil>(after) - momentum<Stencil>(before)), 1e-16);
      }
  });
}

TYPED_TEST(CollisionLaw, LeavesEquilibriumAsItIs) {
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    const bool flat = Stencil::dimensions == 2;
    const CellState state{1.02, {0.05, -0.03, flat ? 0 : 0.07}, {}};
    for (const double tau : relaxation_times) {
      const auto before = populations_of<Stencil>(state, TypeParam::rates(input_of(tau)), {{}, 1});
      const auto after = collided<TypeParam, NoForce, Stencil>(before, input_of(tau));
      for (std::size_t i = 0; i < Stencil::size; ++i) EXPECT_NEAR(after[i], before[i], 2e-17) << Stencil::name << i;
    }
  });
}

TYPED_TEST(CollisionLaw, CommutesWithTheSymmetriesOfTheLattice) {
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    const auto before = random_populations<Stencil>(this->engine);
    const auto after = collided<TypeParam, NoForce, Stencil>(before, input_of(0.6));
    Cells axes{0, 1, 2};
    do {
      if (Stencil::dimensions == 2 && axes[2] != 2) continue;
      for (int signs = 0; signs < 8; ++signs) {
        std::array<std::size_t, Stencil::size> image;
        for (std::size_t i = 0; i < Stencil::size; ++i) {
          Cells c;
          for (std::size_t a = 0; a < 3; ++a)
            c[a] = (signs >> a & 1 ? -1 : 1) * Stencil::velocity[i][std::size_t(axes[a])];
          image[i] =
              std::size_t(std::find(Stencil::velocity.begin(), Stencil::velocity.end(), c) - Stencil::velocity.begin());
        }
        auto turned = before;
        for (std::size_t i = 0; i < Stencil::size; ++i) turned[image[i]] = before[i];
        turned = collided<TypeParam, NoForce, Stencil>(turned, input_of(0.6));
        for (std::size_t i = 0; i < Stencil::size; ++i) EXPECT_NEAR(turned[image[i]], after[i], 2e-17);
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
  });
}

/// Decay per step of a shear wave along `direction`, measured between `from` and `from + steps`.
double measured_factor(std::string_view stencil, std::string_view collision, const CollisionInput& rates, bool tilted,
                       int cells, int from, int steps) {
  FluidSetup setup = fluid_setup(std::string(stencil), {tilted ? cells : 1, cells, 1});
  setup.collision = collision, setup.rates = rates;
  SmallFluid fluid(setup);
  const double wave_number = 2 * pi / cells;
  const auto wave = [&](const Cells& c) { return std::cos(wave_number * (c[1] + (tilted ? c[0] : 0))); };
  const Vec3<double> polarisation = tilted ? Vec3<double>{std::sqrt(0.5), -std::sqrt(0.5), 0} : Vec3<double>{1, 0, 0};
  fluid.start([&](const Cells& c) { return CellState{1, 1e-9 * wave(c) * polarisation, {}}; });
  const auto amplitude = [&] {
    double sum = 0;
    fluid.for_each([&](const Cells& c, const CellState& state) { sum += wave(c) * dot(state.velocity, polarisation); });
    return sum;
  };
  fluid.advance(from);
  const double first = amplitude();
  fluid.advance(steps);
  return std::pow(amplitude() / first, 1.0 / steps);
}

/// Default rates beyond shear and odd: MRT is TRT then, and the linear lattice knows it.
CollisionInput plain_input(double relaxation_time) {
  CollisionInput input;
  input.relaxation_time = relaxation_time, input.magic_parameter = 0.13;
  return input;
}

TYPED_TEST(CollisionLaw, ShearWavesDecayAsTheLinearLatticeDoes) {
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    for (const double tau : relaxation_times) {
      const int cells = tau > 2 ? 32 : 12;  // the wave must outlive all other modes
      const double k = 2 * pi / cells, half = std::sqrt(0.5);
      const RelaxationRates rates = TypeParam::rates(plain_input(tau));
      const int from = tau < 0.55 ? 900 : 150;
      // Along an axis shear waves touch neither the trace nor higher even moments, so that any rates will do.
      const double straight = shear_wave_factor<Stencil>({0, k, 0}, {1, 0, 0}, rates.shear, rates.odd);
      for (const CollisionInput& input : {plain_input(tau), input_of(tau)})
        EXPECT_NEAR(std::log(measured_factor(Stencil::name, TypeParam::name, input, false, cells, from, 20)) /
                        std::log(straight),
                    1, 1e-8)
            << Stencil::name << " tau " << tau;
      const double tilted = shear_wave_factor<Stencil>({k, k, 0}, {half, -half, 0}, rates.shear, rates.odd);
      EXPECT_NEAR(std::log(measured_factor(Stencil::name, TypeParam::name, plain_input(tau), true, cells, from, 20)) /
                      std::log(tilted),
                  1, 1e-8)
          << Stencil::name << " tau " << tau;
    }
  });
}

TYPED_TEST(CollisionLaw, ViscosityFollowsFromTheRelaxationTimeStraightAndTilted) {
  for (const double tau : {0.6, 1.0, 3.0})
    for (const bool tilted : {false, true}) {
      const double viscosity = kinematic_viscosity_lu(tau);
      const auto error = [&](int cells) {
        const double k = 2 * pi / cells, k_squared = k * k * (tilted ? 2 : 1);
        const double factor = measured_factor("D2Q9", TypeParam::name, input_of(tau), tilted, cells, 60, 20);
        return -std::log(factor) / (viscosity * k_squared) - 1;
      };
      const int cells = tau > 2 ? 64 : 24;
      const double coarse = error(cells), fine = error(2 * cells);
      EXPECT_LT(std::abs(fine), 0.012) << tau << tilted;
      EXPECT_LT(std::abs(4 * fine - coarse) / 3, tau > 2 ? 2e-3 : 1e-4) << tau << tilted << coarse << " " << fine;
    }
}

TYPED_TEST(CollisionLaw, BulkViscosityFollowsFromItsRate) {
  // A sound wave keeps |rho|^2 + |j|^2/cs^2 up to exp(-2 G t) over whole periods, G = k^2 (2 (1 - 1/D) nu + zeta)/2,
  // zeta = (2/D)(1/bulk rate - 1/2)/3.
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    const CollisionInput input{0.8, 0.13, 1.4, 1.1};
    const RelaxationRates rates = TypeParam::rates(input);
    FluidSetup setup = fluid_setup(std::string(Stencil::name), {97, 1, 1});  // 97 cells: a period of 168.01 steps
    setup.collision = TypeParam::name, setup.rates = input;
    SmallFluid fluid(setup);
    const double k = 2 * pi / 97;
    fluid.start([&](const Cells& c) { return CellState{1 + 1e-8 * std::cos(k * c[0]), {}, {}}; });
    const auto energy = [&] {
      std::complex<double> density = 0, momentum = 0;
      fluid.for_each([&](const Cells& c, const CellState& state) {
        density += std::polar(1.0, k * c[0]) * (state.density - 1);
        momentum += std::polar(1.0, k * c[0]) * state.velocity.x;
      });
      return std::norm(density) + 3 * std::norm(momentum);
    };
    fluid.advance(168);
    const double first = energy();
    fluid.advance(168);
    const double measured = -std::log(energy() / first) / (2 * 168);
    const double d = Stencil::dimensions, shear = (1 / rates.shear - 0.5) / 3,
                 bulk = 2 / d * (1 / rates.bulk - 0.5) / 3;
    EXPECT_NEAR(measured / (0.5 * k * k * (2 * (1 - 1 / d) * shear + bulk)), 1, 0.01) << Stencil::name;
  });
}

TEST(Mrt, EqualsTrtWithEqualRates) {
  std::mt19937 engine(5);
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    for (const double tau : relaxation_times) {
      const CollisionInput input{tau, 0.2, std::nullopt, std::nullopt};
      const auto f = random_populations<Stencil>(engine);
      const auto trt = collided<Trt, NoForce, Stencil>(f, input), mrt = collided<Mrt, NoForce, Stencil>(f, input);
      for (std::size_t i = 0; i < Stencil::size; ++i) EXPECT_NEAR(mrt[i], trt[i], 2e-17);
    }
  });
}

TEST(Mrt, RelaxesEveryMomentWithItsOwnRate) {
  // Departures without density and momentum; their moments must shrink by 1 - rate.
  std::mt19937 engine(6);
  Stencils::for_each([&](auto tag) {
    using Stencil = typename decltype(tag)::type;
    constexpr int d = Stencil::dimensions;
    const CollisionInput input = input_of(0.7);
    const RelaxationRates rates = Mrt::rates(input);
    const auto f = random_populations<Stencil>(engine);
    const Moments<double> m = moments_of(in_pairs<Stencil>(f));
    const auto eq = populations_of<Stencil>({m.density(), m.momentum / m.density(), {}}, rates, {{}, 1});
    const auto after = collided<Mrt, NoForce, Stencil>(f, input);
    // Moment of the departure from equilibrium under the polynomial p(c), before and after.
    const auto expect_rate = [&](double rate, auto&& p) {
      double before = 0, left = 0;
      for (std::size_t i = 0; i < Stencil::size; ++i) {
        const auto& c = Stencil::velocity[i];
        const double value = p(double(c[0]), double(c[1]), double(c[2]));
        before += value * (f[i] - eq[i]), left += value * (after[i] - eq[i]);
      }
      EXPECT_NEAR(left, (1 - rate) * before, 1e-15) << Stencil::name << " rate " << rate;
    };
    expect_rate(rates.shear, [](double x, double y, double) { return x * y; });
    expect_rate(rates.shear, [](double x, double y, double) { return x * x - y * y; });
    expect_rate(rates.bulk, [](double x, double y, double z) { return x * x + y * y + z * z; });
    expect_rate(rates.odd, [](double x, double y, double) { return x * (y * y - 1.0 / 3); });
    if constexpr (d == 2)
      expect_rate(rates.higher_even, [](double x, double y, double) { return (x * x - 1.0 / 3) * (y * y - 1.0 / 3); });
    if constexpr (Stencil::size == 27) {
      expect_rate(rates.odd, [](double x, double y, double z) { return x * y * z; });
      expect_rate(rates.higher_even,
                  [](double x, double y, double z) { return (x * x - 1.0 / 3) * (y * y - 1.0 / 3) * (z * z + 1); });
      expect_rate(rates.higher_even, [](double x, double y, double z) { return x * y * (z * z - 1.0 / 3); });
    }
  });
}

/// nu <u> / F of a cubic array of spheres made of solid cells, 10 cells apart, radius 3.6 cells.
double permeability(std::string_view collision, double relaxation_time, double magic_parameter) {
  const int n = 10;
  FluidSetup setup = fluid_setup("D3Q19", {n, n, n});
  setup.collision = collision, setup.rates.relaxation_time = relaxation_time;
  setup.rates.magic_parameter = magic_parameter, setup.forcing = "guo";
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) setup.solid.push_back(std::hypot(x - 4.5, y - 4.5, z - 4.5) < 3.6);
  SmallFluid fluid(setup);
  const double force = 1e-9;
  fluid->set_force_density({force, 0, 0});
  fluid.start_at_rest();
  const double viscosity = kinematic_viscosity_lu(relaxation_time);
  double flow = 0, before = 1;
  for (int n_checks = 0; n_checks < 200 && std::abs(flow / before - 1) > 1e-9; ++n_checks) {
    before = flow;
    fluid.advance(2 * int(10 / viscosity / 2) + 1);
    flow = fluid.totals().momentum.x;
  }
  for (const std::uint8_t solid : setup.solid) flow += solid ? 0 : 0.5 * force;
  return viscosity * flow / (n * n * n * force);
}

TEST(Trt, StokesFlowDependsOnTheViscosityOnlyThroughTheDrag) {
  const double reference = permeability("TRT", 1.5, 3.0 / 16);
  EXPECT_NEAR(permeability("TRT", 0.6, 3.0 / 16) / reference, 1, 1e-6);
  EXPECT_NEAR(permeability("MRT", 0.6, 3.0 / 16) / reference, 1, 1e-6);
  // One relaxation time moves the walls: what the test would see.
  EXPECT_GT(permeability("BGK", 1.5, 0) / permeability("BGK", 0.6, 0), 1.05);
}

}  // namespace
}  // namespace stresslet
