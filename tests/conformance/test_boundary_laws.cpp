// Every law in BoundaryLaws: rest, mass, steady flows with closed forms, symmetry, restart; solid cells; refusals.
#include <gtest/gtest.h>

#include "../small_fluid.hpp"
#include "stresslet/lattice/boundary/laws.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

using namespace testing;

struct StencilOf {
  std::string name;
  int dimensions;
};

std::vector<StencilOf> stencils() {
  std::vector<StencilOf> all;
  Stencils::for_each([&](auto s) {
    using Stencil = typename decltype(s)::type;
    all.push_back({std::string(Stencil::name), Stencil::dimensions});
  });
  return all;
}

bool is_wall(std::string_view law) {
  bool wall = false;
  BoundaryLaws::dispatch(law, [&](auto l) { wall = decltype(l)::type::is_wall; });
  return wall;
}

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

/// Faces of this law across `axis`, the rest periodic.
FluidSetup between_faces(const StencilOf& stencil, int axis, const std::string& law, const Cells& size) {
  FluidSetup setup = fluid_setup(stencil.name, size);
  setup.grid.closure[std::size_t(axis)] = Closure::open;
  for (FaceSetup& face : setup.faces[std::size_t(axis)]) face.law = law;
  return setup;
}

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
  if (!wall() && !sets_velocity()) GTEST_SKIP() << "prescribes no velocity";
  for (const StencilOf& stencil : stencils())
    for (const double tau : {0.55, 0.9, 3.0})
      for (int axis = 0; axis < stencil.dimensions; ++axis) {
        const int n = 7, flow = (axis + 1) % stencil.dimensions;
        Cells size{1, 1, 1};
        size[std::size_t(axis)] = n;
        FluidSetup setup = between_faces(stencil, axis, law(), size);
        setup.rates.relaxation_time = tau, setup.forcing = "guo";
        SmallFluid fluid(setup);
        const double force = 1e-10, viscosity = kinematic_viscosity_lu(tau), half = 0.5 * (n - 1) + outside();
        fluid->set_force_density(along_axis(flow, force));
        fluid.start_at_rest();
        fluid.advance(int(200 / viscosity));
        const double peak = force * half * half / (2 * viscosity);
        fluid.for_each([&](const Cells& c, const CellState& state) {
          const double y = c[std::size_t(axis)] - 0.5 * (n - 1);
          EXPECT_NEAR(component(state.velocity, flow) / peak, 1 - y * y / (half * half), regularised() ? 0.5 : 1e-9)
              << stencil.name << " tau " << tau << " axis " << axis;
        });
      }
}

TEST(HalfWayWall, SlipsAsTheMagicParameterTells) {
  // F/(8 nu) ((16/3) Lambda - 1) at the wall, added to the parabola; BGK has Lambda = (tau - 1/2)^2.
  for (const std::string law : {"half-way", "full-way"})
    for (const std::string collision : {"TRT", "BGK"})
      for (const double tau : {0.6, 0.5 + std::sqrt(3.0) / 4, 2.0}) {
        const int n = 7;
        FluidSetup setup = between_faces({"D3Q19", 3}, 1, law, {1, n, 1});
        setup.rates.relaxation_time = tau, setup.rates.magic_parameter = 1.0 / 12, setup.collision = collision;
        setup.forcing = "guo";
        const double magic = collision == "BGK" ? (tau - 0.5) * (tau - 0.5) : 1.0 / 12;
        SmallFluid fluid(setup);
        const double force = 1e-10, viscosity = kinematic_viscosity_lu(tau);
        fluid->set_force_density({force, 0, 0});
        fluid.start_at_rest();
        fluid.advance(int(300 / viscosity));
        const double slip = force / (8 * viscosity) * (16.0 / 3 * magic - 1);
        fluid.for_each([&](const Cells& c, const CellState& state) {
          const double y = c[1] + 0.5;
          EXPECT_NEAR(state.velocity.x / (force / (2 * viscosity)), y * (n - y) + slip * 2 * viscosity / force, 1e-8)
              << law << collision << tau;
        });
      }
}

/// Some smooth field without symmetry.
CellState swirl(const Cells& c, bool flat) {
  const double x = 0.7 * c[0], y = 0.9 * c[1], z = flat ? 0 : 1.1 * c[2];
  return {1 + 0.01 * std::sin(x + 2 * y + z),
          {0.02 * std::sin(y - z), 0.03 * std::cos(x + z), flat ? 0 : 0.01 * std::sin(x - 2 * y)},
          {}};
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
      for (const bool with_solid : {false, true})
        for (const int steps : {6, 7}) {
          if (single && stencil.name != "D3Q19") continue;
          const bool flat = stencil.dimensions == 2;
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
                   {{1, 1, 1}, 2}, {{1, 1, 1}, 3}, {{2, 1, 1}, 1}, {{2, 2, nz}, 2}, {{3, 1, nz}, 3}, {{1, 4, 1}, 2}})
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

TEST(Openings, DriveAChannelAndADuctLikeABodyForce) {
  // Between pressures rho_in and rho_out on the outermost nodes the flow is that of F = (rho_in - rho_out) / (3 (nx -
  // 1)), up to compressibility.
  for (const std::string law : {"pressure", "regularised-pressure"})
    for (const auto& [stencil, size] :
         std::vector<std::pair<std::string, Cells>>{{"D2Q9", {9, 6, 1}}, {"D3Q19", {9, 6, 5}}, {"D3Q27", {9, 6, 5}}}) {
      FluidSetup setup = fluid_setup(stencil, size, {Closure::open, Closure::open, Closure::periodic});
      if (size[2] > 1) setup.grid.closure[2] = Closure::open;
      setup.rates.relaxation_time = 0.9;
      setup.faces[0][0].law = setup.faces[0][1].law = law;
      const double drop = 1e-8;
      setup.faces[0][0].density_lu = 1 + drop;
      SmallFluid driven(setup);
      driven.start_at_rest();
      driven.advance(3000);

      setup.grid.closure[0] = Closure::periodic, setup.forcing = "guo";
      SmallFluid pushed(setup);
      pushed->set_force_density({drop / 3 / (size[0] - 1), 0, 0});
      pushed.start_at_rest();
      pushed.advance(3000);
      const double peak = pushed.at({4, size[1] / 2, size[2] / 2}).velocity.x;
      for (const Cells c : {Cells{4, 0, 0}, {4, 2, 0}, {4, 3, size[2] / 2}, {0, 1, 0}, {8, 2, size[2] / 2}})
        std::printf("%s %s %d%d%d: %g\n", law.c_str(), stencil.c_str(), c[0], c[1], c[2],
                    driven.at(c).velocity.x / peak - pushed.at(c).velocity.x / peak);
    }
}

TEST(Openings, WhatComesInGoesOut) {
  for (const std::string prefix : {"", "regularised-"})
    for (const auto& [stencil, size] :
         std::vector<std::pair<std::string, Cells>>{{"D2Q9", {24, 8, 1}}, {"D3Q19", {20, 8, 8}}}) {
      FluidSetup setup = fluid_setup(stencil, size, {Closure::open, Closure::open, Closure::periodic});
      if (size[2] > 1) setup.grid.closure[2] = Closure::open;
      setup.rates.relaxation_time = 0.9;
      setup.faces[0][0].law = prefix + "velocity", setup.faces[0][1].law = prefix + "pressure";
      setup.faces[0][0].velocity_lu = {1e-4, 0, 0};
      SmallFluid fluid(setup);
      fluid.start_at_rest();
      fluid.advance(3000);
      std::vector<double> flux(std::size_t{0} + size[0]);
      fluid.for_each([&](const Cells& c, const CellState& s) { flux[std::size_t(c[0])] += s.density * s.velocity.x; });
      const double expected = 1e-4 * size[1] * size[2];
      for (const int x : {0, 1, 2, size[0] / 2, size[0] - 2, size[0] - 1})
        std::printf("%s %s %d: %g\n", prefix.c_str(), stencil.c_str(), x, flux[std::size_t(x)] / expected - 1);
      double highest = 0;
      fluid.for_each([&](const Cells& c, const CellState& s) {
        if (c[0] == size[0] * 3 / 4) highest = std::max(highest, s.velocity.x);
      });
      std::printf("peak / mean %g\n", highest / (flux[std::size_t(size[0] * 3 / 4)] / size[1] / size[2]));
    }
}

TEST(SolidCells, MakeTheSameWallsAsOpenFaces) {
  for (const StencilOf& stencil : stencils())
    for (const bool single : {false, true})
      for (const int steps : {8, 9}) {
        if (single && stencil.name != "D3Q19") continue;
        const bool flat = stencil.dimensions == 2;
        const int nz = flat ? 1 : 3;
        const auto state = [&](const Cells& c) { return swirl(c, flat); };
        FluidSetup open = between_faces(stencil, 1, "half-way", {5, 4, nz});
        open.single_precision = single, open.forcing = "guo";
        SmallFluid walls(open);
        walls->set_force_density({1e-4, 2e-4, 0});
        walls.start(state);
        walls.advance(steps);

        FluidSetup closed = fluid_setup(stencil.name, {5, 6, nz});
        closed.single_precision = single, closed.forcing = "guo", closed.grid.blocks = {1, 2, 1};
        for (int z = 0; z < nz; ++z)
          for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 5; ++x) closed.solid.push_back(y == 0 || y == 5);
        SmallFluid solid(closed);
        solid->set_force_density({1e-4, 2e-4, 0});
        solid.start([&](const Cells& c) { return state({c[0], c[1] - 1, c[2]}); });
        solid.advance(steps);
        walls.for_each([&](const Cells& c, const CellState& expected) {
          const CellState found = solid.at({c[0], c[1] + 1, c[2]});
          EXPECT_EQ(found.density, expected.density);
          EXPECT_EQ(found.velocity, expected.velocity);
          EXPECT_EQ(found.strain_rate, expected.strain_rate);
        });
        const auto a = walls.totals(), b = solid.totals();
        EXPECT_EQ(a.mass_deviation, b.mass_deviation);
        EXPECT_EQ(a.momentum, b.momentum);
        EXPECT_EQ(a.lowest_density, b.lowest_density);
        EXPECT_EQ(solid.at({2, 0, 0}).density, 1);
        EXPECT_EQ(solid.at({2, 5, 0}).velocity, Vec3<double>{});
      }
}

TEST(Boundaries, RefuseContradictions) {
  const auto complaint = [](const FluidSetup& setup) -> std::string {
    try {
      Fluid::make(setup);
      return "";
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
  };
  FluidSetup setup = fluid_setup("D3Q19", {4, 4, 4}, {Closure::open, Closure::open, Closure::periodic});
  EXPECT_EQ(complaint(setup), "");
  setup.faces[0][1].law = "sponge";
  EXPECT_NE(complaint(setup).find("unknown boundary law 'sponge' on the upper face of x"), std::string::npos);
  setup.faces[0][1].law = "pressure";
  EXPECT_EQ(complaint(setup), "");
  setup.faces[1][0].law = "velocity";
  EXPECT_NE(complaint(setup).find("openings on faces of x and y"), std::string::npos);
  setup.faces[1][0] = {"full-way", {0, 0.1, 0}, 1};
  EXPECT_NE(complaint(setup).find("the wall on the lower face of y moves through itself"), std::string::npos);
  setup.faces[1][0] = {};
  setup.faces[0][1].density_lu = 0;
  EXPECT_NE(complaint(setup).find("needs a positive density"), std::string::npos);
  setup.faces[0][1].density_lu = 1, setup.grid.size[0] = 1;
  EXPECT_NE(complaint(setup).find("needs two cells across"), std::string::npos);
  setup.grid.size[0] = 4, setup.solid.resize(63);
  EXPECT_NE(complaint(setup).find("63 values for 64 cells"), std::string::npos);
  setup = fluid_setup("D3Q19", {4, 4, 4}, {Closure::periodic, Closure::sheared, Closure::periodic});
  setup.solid.resize(64);
  EXPECT_EQ(complaint(setup), "");
  setup.solid[5] = 1;
  EXPECT_EQ(complaint(setup), "");
  setup.solid[1] = 1;
  EXPECT_NE(complaint(setup).find("solid cells at a sheared face, at x = 1, z = 0"), std::string::npos);
  setup = fluid_setup("D2Q9", {4, 4, 1}, {Closure::periodic, Closure::periodic, Closure::open});
  EXPECT_NE(complaint(setup).find("two-dimensional"), std::string::npos);
}

}  // namespace
}  // namespace stresslet
