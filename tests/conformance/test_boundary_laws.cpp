// Every law in BoundaryLaws: rest, mass, steady flows with closed forms, symmetry, blocks, restart.
#include <gtest/gtest.h>

#include "../boundary_cases.hpp"

namespace stresslet {
namespace {

using namespace testing;

class BoundaryLaw : public ::testing::TestWithParam<std::string> {
 protected:
  std::string law() const { return GetParam(); }
  bool wall() const { return is_wall(law()); }
  bool regularised() const { return law().starts_with("regularised"); }
  bool sets_velocity() const { return law().ends_with("velocity"); }
  /// Distance of the boundary outside the centres of the last cells.
  double outside() const { return wall() ? 0.5 : 0; }
};
INSTANTIATE_TEST_SUITE_P(All, BoundaryLaw, ::testing::ValuesIn(BoundaryLaws::names()), [](const auto& param) {
  std::string name = param.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST_P(BoundaryLaw, LeavesFluidAtRestExactlyAtRest) {
  for (const StencilOf& stencil : stencils())
    for (const bool single : {false, true})
      for (int axis = 0; axis < stencil.dimensions; ++axis) {
        if (single && stencil.name != "D3Q19") continue;
        FluidSetup setup = between_faces(stencil, axis, law(), {5, 4, stencil.dimensions == 3 ? 3 : 1});
        setup.single_precision = single;
        SmallFluid fluid(setup);
        fluid.start_at_rest();
        for (int n = 0; n < 2; ++n) {
          fluid.advance(3);
          for (const double f : fluid.populations()) ASSERT_EQ(f, 0.0);
        }
      }
}

TEST_P(BoundaryLaw, MovingAlongItselfDrivesCouetteFlowExactly) {
  if (!wall() && !sets_velocity()) GTEST_SKIP() << "prescribes no velocity";
  for (const StencilOf& stencil : stencils())
    for (const double tau : {0.6, 1.0, 2.0})
      for (int axis = 0; axis < stencil.dimensions; ++axis) {
        const int n = 6, flow = (axis + 1) % stencil.dimensions;
        Cells size{1, 1, 1};
        size[std::size_t(axis)] = n;
        FluidSetup setup = between_faces(stencil, axis, law(), size);
        setup.rates.relaxation_time = tau;
        const double low = -1e-8, high = 3e-8;
        setup.faces[std::size_t(axis)][0].velocity_lu = along_axis(flow, low);
        setup.faces[std::size_t(axis)][1].velocity_lu = along_axis(flow, high);
        SmallFluid fluid(setup);
        fluid.start_at_rest();
        fluid.advance(int(160 / kinematic_viscosity_lu(tau)));
        const double width = n - 1 + 2 * outside();
        fluid.for_each([&](const Cells& c, const CellState& state) {
          const double expected = low + (high - low) * (c[std::size_t(axis)] + outside()) / width;
          EXPECT_NEAR(component(state.velocity, flow), expected, 1e-13 * high) << stencil.name << tau << axis;
          const SymTensor3<double>& s = state.strain_rate;
          const double sheared = axis + flow == 1 ? s.xy : axis + flow == 2 ? s.xz : s.yz;
          EXPECT_NEAR(sheared, 0.5 * (high - low) / width, 1e-12 * high) << stencil.name << tau << axis;
        });
      }
}

TEST_P(BoundaryLaw, PoiseuilleFlowIsAParabola) {
  // Half-way and full-way walls at magic parameter 3/16, and Zou-He at any, are exact at the nodes; regularised faces
  // of second order.
  if (regularised() || (!wall() && !sets_velocity())) GTEST_SKIP() << "of second order, or prescribes no velocity";
  for (const StencilOf& stencil : stencils())
    for (const double tau : {0.55, 0.9, 3.0})
      for (int axis = 0; axis < stencil.dimensions; ++axis) {
        const int n = 7, flow = (axis + 1) % stencil.dimensions;
        Cells size{1, 1, 1};
        size[std::size_t(axis)] = n;
        FluidSetup setup = between_faces(stencil, axis, law(), size);
        setup.rates.relaxation_time = tau, setup.forcing = "guo";
        setup.rates.magic_parameter = wall() ? 3.0 / 16 : 0.1;
        SmallFluid fluid(setup);
        const double force = 1e-10, viscosity = kinematic_viscosity_lu(tau), half = 0.5 * (n - 1) + outside();
        fluid->set_force_density(along_axis(flow, force));
        fluid.start_at_rest();
        fluid.advance(int(200 / viscosity));
        const double peak = force * half * half / (2 * viscosity);
        fluid.for_each([&](const Cells& c, const CellState& state) {
          const double y = c[std::size_t(axis)] - 0.5 * (n - 1);
          EXPECT_NEAR(component(state.velocity, flow) / peak, 1 - y * y / (half * half), 1e-9)
              << stencil.name << " tau " << tau << " axis " << axis;
        });
      }
}

std::vector<std::uint8_t> some_solid(const Cells& n) {
  std::vector<std::uint8_t> solid;
  for (int z = 0; z < n[2]; ++z)
    for (int y = 0; y < n[1]; ++y)
      for (int x = 0; x < n[0]; ++x) solid.push_back((x * 7 + y * 3 + z * 5) % 11 == 2 || (x < 2 && y > 1 && y < 4));
  return solid;
}

/// The law on both faces of x, half-way walls across y, the first moving.
FluidSetup mixed(const StencilOf& stencil, const std::string& law, bool single, bool with_solid) {
  const bool flat = stencil.dimensions == 2;
  FluidSetup setup = between_faces(stencil, 0, law, {7, 6, flat ? 1 : 5});
  setup.grid.closure[1] = Closure::open;
  setup.faces[1][0].velocity_lu = {0.01, 0, 0};
  for (FaceSetup& face : setup.faces[0]) {
    if (is_wall(law))
      face.velocity_lu = {0, 0.02, flat ? 0 : -0.01};
    else
      face.velocity_lu = {0.01, 0, 0};
    face.density_lu = 1.002;
  }
  setup.single_precision = single, setup.forcing = "guo", setup.rates.relaxation_time = 0.8;
  if (with_solid) setup.solid = some_solid(setup.grid.size);
  return setup;
}

TEST_P(BoundaryLaw, GivesTheSameBitsForAnyBlocksAndThreads) {
  for (const StencilOf& stencil : stencils())
    for (const bool single : {false, true})
      for (const bool with_solid : {false, true}) {
        if (single && stencil.name != "D3Q19") continue;
        const bool flat = stencil.dimensions == 2;
        const int steps = with_solid ? 7 : 6;
        const auto run = [&](const Cells& blocks, int threads) {
          FluidSetup setup = mixed(stencil, law(), single, with_solid);
          setup.grid.blocks = blocks;
          SmallFluid fluid(setup, threads);
          fluid->set_force_density({1e-4, -2e-4, flat ? 0 : 3e-4});
          fluid.start([&](const Cells& c) { return swirl(c, flat); });
          fluid.advance(steps);
          return fluid.populations();
        };
        const std::vector<double> expected = run({1, 1, 1}, 1);
        for (const double f : expected) ASSERT_TRUE(std::isfinite(f));
        const int nz = flat ? 1 : 2;
        for (const auto& [blocks, threads] : std::vector<std::pair<Cells, int>>{
                 {{1, 1, 1}, 3}, {{2, 1, 1}, 1}, {{2, 2, nz}, 2}, {{3, 1, nz}, 1}, {{1, 4, 1}, 3}})
          EXPECT_EQ(run(blocks, threads), expected)
              << stencil.name << single << with_solid << " blocks " << blocks[0] << blocks[1] << blocks[2];
      }
}

TEST_P(BoundaryLaw, ContinuesWithTheSameBitsAfterARestart) {
  for (const StencilOf& stencil : stencils())
    for (const bool single : {false, true})
      for (const int steps : {4, 5}) {
        if (single && stencil.name != "D3Q19") continue;
        const bool flat = stencil.dimensions == 2;
        FluidSetup setup = mixed(stencil, law(), single, true);
        SmallFluid fluid(setup);
        fluid->set_force_density({1e-4, -2e-4, 0});
        fluid.start([&](const Cells& c) { return swirl(c, flat); });
        fluid.advance(steps);
        const std::vector<double> saved = fluid.populations();
        fluid.advance(3);
        setup.grid.blocks = {2, 1, 1};
        SmallFluid again(setup);
        again->set_force_density({1e-4, -2e-4, 0});
        again.start([&](const Cells& c) { return swirl(c, flat); });
        again.advance(1);
        again.restore(saved, steps);
        EXPECT_EQ(again.populations(), saved) << stencil.name;
        again.advance(3);
        EXPECT_EQ(again.populations(), fluid.populations()) << stencil.name;
        EXPECT_EQ(again->steps(), steps + 3);
      }
}

TEST_P(BoundaryLaw, MeasuringChangesNothing) {
  FluidSetup setup = mixed({"D3Q19", 3}, law(), false, true);
  const auto run = [&](bool measured) {
    SmallFluid fluid(setup);
    fluid.start([](const Cells& c) { return swirl(c, false); });
    for (int n = 0; n < 5; ++n) {
      fluid.advance(1);
      if (measured) fluid.totals(), fluid.totals();
    }
    return fluid.populations();
  };
  EXPECT_EQ(run(true), run(false));
}

TEST_P(BoundaryLaw, TurnsWithTheAxes) {
  for (const StencilOf& stencil : stencils()) {
    const int d = stencil.dimensions;
    const auto run = [&](int shift) {  // axis a of the first run becomes axis a + shift
      const auto turn = [&](const Vec3<double>& v) {
        Vec3<double> t{};
        for (int a = 0; a < d; ++a) t += along_axis((a + shift) % d, component(v, a));
        return t;
      };
      Cells size{1, 1, 1}, original{6, 5, d == 3 ? 4 : 1};
      for (int a = 0; a < d; ++a) size[std::size_t((a + shift) % d)] = original[std::size_t(a)];
      FluidSetup setup = between_faces(stencil, shift, law(), size);
      const auto side = std::size_t((shift + 1) % d);
      setup.grid.closure[side] = Closure::open;
      if (wall()) setup.faces[side][0].law = setup.faces[side][1].law = law();
      for (FaceSetup& face : setup.faces[std::size_t(shift)]) {
        face.velocity_lu = turn({wall() ? 0 : 0.01, 0.02, 0});
        face.density_lu = 1.003;
      }
      setup.forcing = "guo";
      SmallFluid fluid(setup);
      fluid->set_force_density(turn({1e-4, 3e-4, 0}));
      const auto back = [&](const Cells& c) {
        Cells b{0, 0, 0};
        for (int a = 0; a < d; ++a) b[std::size_t(a)] = c[std::size_t((a + shift) % d)];
        return b;
      };
      fluid.start([&](const Cells& c) {
        CellState state = swirl(back(c), d == 2);
        state.velocity = turn(state.velocity);
        return state;
      });
      fluid.advance(9);
      const int cells = size[0] * size[1] * size[2];
      std::vector<std::pair<double, Vec3<double>>> field(std::size_t{0} + cells);
      fluid.for_each([&](const Cells& c, const CellState& state) {
        const Cells b = back(c);
        Vec3<double> v{};
        for (int a = 0; a < d; ++a) v += along_axis(a, component(state.velocity, (a + shift) % d));
        field[std::size_t(b[0] + original[0] * (b[1] + original[1] * b[2]))] = {state.density, v};
      });
      return field;
    };
    const auto expected = run(0);
    for (int shift = 1; shift < d; ++shift) {
      const auto turned = run(shift);
      for (std::size_t k = 0; k < expected.size(); ++k) {
        EXPECT_NEAR(turned[k].first, expected[k].first, 1e-15) << stencil.name;
        EXPECT_LT(norm(turned[k].second - expected[k].second), 1e-15) << stencil.name;
      }
    }
  }
}

TEST_P(BoundaryLaw, ConservesMassOrHoldsWhatItPrescribes) {
  for (const StencilOf& stencil : stencils())
    for (const bool with_solid : {false, true}) {
      const bool flat = stencil.dimensions == 2;
      SmallFluid fluid(mixed(stencil, law(), false, with_solid));
      const Vec3<double> force{1e-4, -2e-4, flat ? 0 : 3e-4};
      fluid->set_force_density(force);
      fluid.start([&](const Cells& c) { return swirl(c, flat); });
      // Everything kept, populations on their way through full-way walls included.
      const auto all_mass = [&] {
        double sum = 0;
        for (const double f : fluid.populations()) sum += f;
        return sum;
      };
      const double before = all_mass();
      fluid.advance(25);
      if (wall()) {
        EXPECT_NEAR(all_mass(), before, 1e-14) << stencil.name << with_solid;
        continue;
      }
      const FluidSetup setup = mixed(stencil, law(), false, with_solid);
      fluid.for_each([&](const Cells& c, const CellState& state) {
        if (c[0] > 0 && c[0] < 6) return;
        const std::size_t cell = std::size_t(c[0] + 7 * (c[1] + 6 * c[2]));
        if (with_solid && setup.solid[cell]) return;
        if (sets_velocity()) {
          EXPECT_LT(norm(state.velocity - Vec3<double>{0.01, 0, 0}), 1e-15) << stencil.name;
        } else {
          EXPECT_NEAR(state.density, 1.002, 1e-15) << stencil.name;
          EXPECT_NEAR(std::hypot(state.velocity.y, state.velocity.z), 0, 1e-15) << stencil.name;
        }
      });
    }
}

/// Velocity in the middle of a channel between pressures on the outermost nodes, over that under the body force
/// (rho_in - rho_out) / (3 (nx - 1)); `cells` between half-way walls.
double pressure_driven_peak(const std::string& law, const std::string& stencil, double relaxation_time, int cells) {
  const int length = 2 * cells;
  const double drop = 1e-9, viscosity = kinematic_viscosity_lu(relaxation_time);
  FluidSetup setup = fluid_setup(stencil, {length + 1, cells, 1}, {Closure::open, Closure::open, Closure::periodic});
  setup.rates.relaxation_time = relaxation_time;
  setup.faces[0][0].law = setup.faces[0][1].law = law;
  setup.faces[0][0].density_lu = 1 + drop;
  SmallFluid fluid(setup);
  fluid.start([&](const Cells& c) { return CellState{1 + drop * (1 - double(c[0]) / length), {}, {}}; });
  fluid.advance(int(3 * cells * cells / viscosity));
  const double y = cells / 2 + 0.5;
  return fluid.at({cells, cells / 2, 0}).velocity.x / (drop / 3 / length / (2 * viscosity) * y * (cells - y));
}

TEST_P(BoundaryLaw, PressureDrivesChannelFlow) {
  // The local error of second order lives within a few cells of the faces, whose share of the length halves as well.
  if (wall() || sets_velocity()) GTEST_SKIP() << "prescribes no pressure";
  for (const std::string stencil : {"D2Q9", "D3Q19", "D3Q27"})
    for (const double tau : {0.6, 1.0}) {
      const double coarse = pressure_driven_peak(law(), stencil, tau, 6) - 1,
                   fine = pressure_driven_peak(law(), stencil, tau, 12) - 1;
      EXPECT_LT(std::abs(coarse), 4e-3) << stencil << tau;
      EXPECT_NEAR(coarse / fine, 8, 0.5) << stencil << tau;
    }
}

}  // namespace
}  // namespace stresslet
