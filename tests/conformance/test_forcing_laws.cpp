// Every law in ForcingLaws: momentum and mass, the spurious stress that each leaves, uniform acceleration, Poiseuille
// flow.
#include <gtest/gtest.h>

#include "../small_fluid.hpp"
#include "random_populations.hpp"
#include "stresslet/lattice/cell_state.hpp"

namespace stresslet {
namespace {

using namespace testing;

template <class Law>
class ForcingLaw : public ::testing::Test {
 protected:
  static constexpr bool forces = !std::is_same_v<Law, NoForce>;
  std::mt19937 engine{13};
};
TYPED_TEST_SUITE(ForcingLaw, GTestTypes<ForcingLaws>::type);

TYPED_TEST(ForcingLaw, AddsExactlyTheForceAndNoMass) {
  Stencils::for_each([&](auto s) {
    CollisionLaws::for_each([&](auto c) {
      using Stencil = typename decltype(s)::type;
      using Collision = typename decltype(c)::type;
      const Vec3<double> force{0.02, -0.01, Stencil::dimensions == 3 ? 0.03 : 0};
      for (const double tau : relaxation_times)
        for (int n = 0; n < 20; ++n) {
          const auto before = random_populations<Stencil>(this->engine);
          const auto after = collided<Collision, TypeParam, Stencil>(before, {tau, 0.13, 1.3, 0.7}, force);
          EXPECT_NEAR(mass<Stencil>(after), mass<Stencil>(before), 4e-16) << Stencil::name << Collision::name;
          const Vec3<double> gained = momentum<Stencil>(after) - momentum<Stencil>(before);
          EXPECT_LT(norm(gained - (this->forces ? 1.0 : 0.0) * force), 4e-16) << Stencil::name << Collision::name;
        }
    });
  });
}

/// Momentum flux beyond rho u u and pressure of uniform flow under a constant force, after `steps` collisions: sum f c
/// c, mean of before and after collision (the flux that Chapman-Enskog analysis finds), minus rho u u of the half-force
/// velocity.
template <class Collision, class Forcing>
SymTensor3<double> spurious_flux(double relaxation_time, const Vec3<double>& velocity, const Vec3<double>& force,
                                 Vec3<double>& velocity_then) {
  using Stencil = D3Q19;
  const CollisionInput input{relaxation_time, 0.13, std::nullopt, std::nullopt};
  auto f = populations_of<Stencil>({1.02, velocity, {}}, Collision::rates(input), {force, 1});
  auto after = f;
  for (int n = 0; n < 800; ++n) {
    f = after;
    after = collided<Collision, Forcing, Stencil>(f, input, force);
  }
  const double density = 1 + mass<Stencil>(f);
  velocity_then = (momentum<Stencil>(f) + 0.5 * force) / density;
  const SymTensor3<double> flux = 0.5 * (second_moment(in_pairs<Stencil>(f)) + second_moment(in_pairs<Stencil>(after)));
  return flux - ((density - 1) / 3) * identity3<double>() - density * square(velocity_then);
}

template <class Collision, class Forcing, class Expected>
void expect_spurious_flux(const Vec3<double>& velocity, const Vec3<double>& force, double relative, double absolute,
                          Expected&& expected) {
  for (const double tau : relaxation_times) {
    const double tau_odd = 1 / Collision::rates({tau, 0.13, std::nullopt, std::nullopt}).odd;
    Vec3<double> u;
    const SymTensor3<double> found = spurious_flux<Collision, Forcing>(tau, velocity, force, u);
    const SymTensor3<double> wanted = expected(u, tau, tau_odd);
    for (const auto part : {&SymTensor3<double>::xx, &SymTensor3<double>::yy, &SymTensor3<double>::zz,
                            &SymTensor3<double>::xy, &SymTensor3<double>::xz, &SymTensor3<double>::yz})
      EXPECT_NEAR(found.*part, wanted.*part, relative * std::abs(wanted.*part) + absolute)
          << Forcing::name << Collision::name << " tau " << tau;
  }
}

const Vec3<double> strong_force{1e-4, -3e-4, 2e-4};

template <class Forcing>
SymTensor3<double> documented_flux(const Vec3<double>& u, const Vec3<double>& force, double density, double tau,
                                   double tau_odd) {
  const double odd_excess = tau_odd - tau;
  if constexpr (std::is_same_v<Forcing, ExactDifference>) return (0.25 / density) * square(force);
  if constexpr (std::is_same_v<Forcing, VelocityShift>)
    return 2 * odd_excess * symmetric_product(u, force) +
           ((odd_excess * odd_excess + (tau - 0.5) * (tau - 0.5)) / density) * square(force);
  return {};
}

TYPED_TEST(ForcingLaw, LeavesTheSpuriousStressThatItsFileStates) {
  if constexpr (std::is_same_v<TypeParam, NoForce>) {
    GTEST_SKIP() << "no force";
  } else if constexpr (std::is_same_v<TypeParam, He>) {
    // -3 (tau - 1/2) (u.F) u u to leading order in F.
    const Vec3<double> weak{1e-8, 2e-8, -3e-8};
    expect_spurious_flux<Trt, He>({0.1, 0.05, 0.08}, weak, 1e-3, 1e-15, [&](const auto& u, double tau, double) {
      return -3 * (tau - 0.5) * dot(u, weak) * square(u);
    });
  } else {
    CollisionLaws::for_each([&](auto c) {
      using Collision = typename decltype(c)::type;
      expect_spurious_flux<Collision, TypeParam>(
          {-0.1, 0.1, 0}, strong_force, 1e-6, 1e-14, [&](const auto& u, double tau, double tau_odd) {
            return documented_flux<TypeParam>(u, strong_force, 1.02, tau, tau_odd);
          });
    });
  }
}

TYPED_TEST(ForcingLaw, AcceleratesAPeriodicBoxUniformly) {
  for (const std::string stencil : {"D3Q19", "D2Q9"})
    for (const std::string& collision : CollisionLaws::names()) {
      FluidSetup setup = fluid_setup(stencil, {5, 3, stencil == "D2Q9" ? 1 : 2});
      setup.collision = collision, setup.forcing = TypeParam::name, setup.rates.relaxation_time = 0.7;
      SmallFluid fluid(setup);
      const Vec3<double> force{1e-4, -2e-4, stencil == "D2Q9" ? 0 : 5e-5};
      fluid->set_force_density(this->forces ? force : Vec3<double>{});
      fluid.start_at_rest();
      for (const int time : {1, 2, 51}) {
        fluid.advance(time - int(fluid->steps()));
        const Vec3<double> expected = (this->forces ? double(time) : 0.0) * force;
        fluid.for_each([&](const Cells&, const CellState& state) {
          EXPECT_NEAR(state.density, 1, 1e-15);
          EXPECT_LT(norm(state.velocity - expected), 1e-16 * time) << stencil << collision << time;
        });
      }
    }
}

TYPED_TEST(ForcingLaw, DrivesPoiseuilleFlowExactly) {
  if (!this->forces) GTEST_SKIP() << "no force";
  for (const double tau : {0.55, 1.0, 3.0}) {
    const int n = 7;
    FluidSetup setup = fluid_setup("D3Q19", {1, n, 1}, {Closure::periodic, Closure::open, Closure::periodic});
    setup.forcing = TypeParam::name, setup.rates.relaxation_time = tau, setup.rates.magic_parameter = 3.0 / 16;
    SmallFluid fluid(setup);
    const double force = 1e-10, viscosity = kinematic_viscosity_lu(tau);
    fluid->set_force_density({force, 0, 0});
    fluid.start_at_rest();
    fluid.advance(int(220 / viscosity));
    fluid.for_each([&](const Cells& c, const CellState& state) {
      const double y = c[1] + 0.5, scale = force / (2 * viscosity);
      EXPECT_NEAR(state.velocity.x / scale, y * (n - y), 1e-9) << tau;
      EXPECT_NEAR(state.strain_rate.xy / scale, 0.5 * (n - 2 * y), 1e-8) << tau;
    });
  }
}

}  // namespace
}  // namespace stresslet
