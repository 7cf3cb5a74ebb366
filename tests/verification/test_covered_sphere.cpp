// A fixed sphere in a cubic periodic box, by the plainest loop over the coupling laws: drag against the exact solution,
// and the momentum of the whole box.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "stresslet/base/constants.hpp"
#include "stresslet/coupling/laws.hpp"
#include "stresslet/coupling/spans.hpp"
#include "stresslet/lattice/laws.hpp"

namespace stresslet {
namespace {

constexpr int length = 20, cells = length * length * length;
constexpr double radius = 5;

// Simple cubic array with diameter half the spacing: Zick & Homsy, J. Fluid Mech. 115 (1982) 13; Sangani & Acrivos,
// Int. J. Multiphase Flow 8 (1982) 193, drag over 6 pi mu a U with U the mean velocity of the whole cell.
constexpr double exact_drag = 2.8420;

int wrapped(int a) { return (a + length) % length; }
int place(int x, int y, int z) { return wrapped(x) + length * (wrapped(y) + length * wrapped(z)); }

/// Incoming populations of all cells; every step collides and streams.
template <class Operator, class Stencil = D3Q19>
class Box {
 public:
  template <class Fraction, class Weight>
  Box(double relaxation_time, const Vec3<double>& centre, const Fraction& law, const Weight& weight)
      : viscosity_(kinematic_viscosity_lu(relaxation_time)),
        rates_(Trt::rates({relaxation_time, 1.0 / 12, std::nullopt, std::nullopt})) {
    const double drawn = Weight::drawn_radius(radius);
    for_each_row_of_sphere(centre, law.touch_radius(drawn), law.full_radius(drawn), [&](const RowSpan& row) {
      for (int x = row.touched.begin; x < row.touched.end; ++x) {
        const Vec3<double> offset{x - centre.x, row.y - centre.y, row.z - centre.z};
        weight_[place(x, row.y, row.z)] = weight.weight(law.fraction(offset, drawn));
      }
    });
  }

  void step() {
    const BodyForce<double> force{{force_, 0, 0}, rates_.odd};
    typename Trt::Cell<Stencil, double> collision(rates_);
    flow_ = 0, given_ = {};
    for (int i = 0; i < cells; ++i) {
      CellPopulations<Stencil, double> f;
      f.rest = in_[i][0];
      for (int k = 1; k < Stencil::size; k += 2) f.pair[k / 2] = {in_[i][k] + in_[i][k + 1], in_[i][k] - in_[i][k + 1]};
      const Moments<double> m = moments_of(f);
      const Vec3<double> given =
          Operator::template collide<Trt, Guo>(f, collision, force, CoveredCell<double>{weight_[i], {}});
      given_ += given;
      flow_ += (m.momentum.x + 0.5 * (force_ + given.x)) / m.density();
      out_[i][0] = f.rest;
      const int x = i % length, y = i / length % length, z = i / (length * length);
      for (int k = 1; k < Stencil::size; k += 2) {
        const auto& c = Stencil::velocity[k];
        const auto& [even, odd] = f.pair[k / 2];
        out_[place(x + c[0], y + c[1], z + c[2])][k] = 0.5 * (even + odd);
        out_[place(x - c[0], y - c[1], z - c[2])][k + 1] = 0.5 * (even - odd);
      }
    }
    std::swap(in_, out_);
    impulse_ += given_.x + force_ * cells;
  }

  double momentum() const {
    double sum = 0;
    for (const auto& f : in_)
      for (int i = 0; i < Stencil::size; ++i) sum += Stencil::velocity[i][0] * f[i];
    return sum;
  }
  /// What forces have given to the box since the start.
  double impulse() const { return impulse_; }
  const Vec3<double>& given() const { return given_; }
  double drag() const { return -given_.x / (6 * pi * viscosity_ * radius * (flow_ / cells)); }
  /// Part of the driving force that still accelerates the box.
  double unsteadiness() const { return 1 + given_.x / (force_ * cells); }

 private:
  using All = std::vector<std::array<double, Stencil::size>>;
  static constexpr double force_ = 1e-6;
  double viscosity_;
  RelaxationRates rates_;
  All in_ = All(cells), out_ = All(cells);
  std::vector<double> weight_ = std::vector<double>(cells);
  double flow_ = 0, impulse_ = 0;
  Vec3<double> given_{};
};

double default_drag(double relaxation_time, const Vec3<double>& centre, int steps) {
  Box<Superposition> box(relaxation_time, centre, PlaneCut{}, ViscosityScaledWeight(relaxation_time));
  for (int n = 0; n < steps; ++n) box.step();
  EXPECT_NEAR(box.unsteadiness(), 0, 2e-3);
  return box.drag();
}

TEST(CoveredSphere, HasTheDragOfACubicArray) {
  Box<Superposition> box(2, {10, 10, 10}, PlaneCut{}, ViscosityScaledWeight(2));
  for (int n = 0; n < 450; ++n) box.step();
  EXPECT_NEAR(box.unsteadiness(), 0, 2e-3);
  EXPECT_NEAR(box.drag() / exact_drag, 1, 4e-3);
  EXPECT_LT(std::hypot(box.given().y, box.given().z), 1e-12 * std::abs(box.given().x));
  EXPECT_NEAR(box.momentum() / box.impulse(), 1, 1e-11);
}

TEST(LongCoveredSphere, HasItsDragAtAnyPlaceAndRelaxationTime) {
  const double reference = default_drag(2, {10, 10, 10}, 450);
  for (const Vec3<double>& centre : {Vec3<double>{10.5, 10.5, 10.5}, {10.31, 10.17, 9.77}, {10, 10.5, 10}})
    EXPECT_NEAR(default_drag(2, centre, 450) / exact_drag, 1, 4e-3);
  EXPECT_NEAR(default_drag(1, {10, 10, 10}, 1500), reference, 1e-3 * exact_drag);
  EXPECT_NEAR(default_drag(0.7, {10, 10, 10}, 3800), reference, 1e-3 * exact_drag);
}

}  // namespace
}  // namespace stresslet
