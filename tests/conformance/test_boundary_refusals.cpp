// Boundaries that contradict each other are refused.
#include <gtest/gtest.h>

#include "../boundary_cases.hpp"

namespace stresslet {
namespace {

using namespace testing;

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
  setup.solid.clear(), setup.grid.closure[2] = Closure::open;
  EXPECT_NE(complaint(setup).find("make x and z periodic"), std::string::npos);
  setup = fluid_setup("D2Q9", {4, 4, 1}, {Closure::periodic, Closure::periodic, Closure::open});
  EXPECT_NE(complaint(setup).find("two-dimensional"), std::string::npos);
}

}  // namespace
}  // namespace stresslet
