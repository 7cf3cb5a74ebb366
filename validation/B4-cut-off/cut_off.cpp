/// Lubrication corrected below a cut-off (Najuch, PhD thesis, University of Edinburgh 2018, chapter 4): two equal
/// spheres that approach each other with +-U, N = 10, superposition with linear weight at tau 0.65. The force of the
/// grid plus F(h) - F(h_cut) for gaps h < h_cut, F = 6 pi eta a U (a/2h + 9/20 ln a/h), against the exact one; the
/// largest error at gaps of up to a cell, by h_cut. The numbers to meet are those of an independent program.
#include <algorithm>
#include <cmath>

#include "stresslet/coupling/subgrid/hard_cut_off.hpp"
#include "stresslet/lubrication/complete.hpp"
#include "stresslet/lubrication/two_spheres_exact.hpp"
#include "validation/harness/unbounded.hpp"

namespace stresslet::validation {

namespace {

constexpr double radius = 5, relaxation_time = 0.65;

/// All forces over 6 pi eta a U, gaps in cells.
double exact_force(double gap) {
  const TwoSphereResistance r = exact_two_spheres(1, 1, gap / radius);
  return (r.XA[0] - r.XA[1]) / (6 * pi);
}

double film_force(double gap) { return 2 * Complete::resistance(1.0, 1.0, gap / radius).X / (6 * pi); }

double corrected(double force, double gap, double cut_off) {
  return force + film_force(gap) - film_force(HardCutOff::resolved_gap(gap, cut_off));
}

double force_of_the_grid(Trial& trial, double gap) {
  const double half = 1 + gap / (2 * radius), force = 6 * pi * exact_force(gap);
  Unbounded setup{.scheme = thesis_scheme(relaxation_time), .clearance = trial.choose(4.0, 2.0)};
  setup.speed = 2e-3 * setup.scheme.viscosity();
  setup.spheres = {{.centre = {0, -half, 0}, .velocity = {0, 1, 0}, .force = Vec3<double>{0, force, 0}},
                   {.centre = {0, half, 0}, .velocity = {0, -1, 0}, .force = Vec3<double>{0, -force, 0}}};
  return -run_unbounded(trial, setup, fmt::format("B4, gap {} cells", gap))[0].force.y;
}

}  // namespace

void cut_off(Trial& trial) {
  const std::vector<double> gaps =
      trial.choose(std::vector<double>{0.1, 0.2, 0.35, 0.5, 0.7, 0.75, 0.8, 0.85, 1.0}, std::vector<double>{0.35});
  trial.parameter("cells per diameter", 2 * radius);
  trial.parameter("relaxation time", relaxation_time);
  Table table{"cut-off",
              {{"gap", "cells", ""},
               {"exact", "6 pi eta a U", ""},
               {"grid", "6 pi eta a U", ""},
               {"corrected below 0.75", "6 pi eta a U", ""}},
              std::vector<std::vector<double>>(4)};
  for (const double gap : gaps) {
    const double force = force_of_the_grid(trial, gap);
    table.values[0].push_back(gap);
    table.values[1].push_back(exact_force(gap));
    table.values[2].push_back(force);
    table.values[3].push_back(corrected(force, gap, 0.75));
  }
  const auto largest_error = [&](double length) {
    double most = 0;
    for (std::size_t k = 0; k < table.values[0].size(); ++k)
      most =
          std::max(most, std::abs(corrected(table.values[2][k], table.values[0][k], length) / table.values[1][k] - 1));
    return most;
  };
  if (trial.quick()) {
    trial.row(fmt::format("gap {} cells, cut-off 0.75: force over exact", gaps[0]),
              table.values[3][0] / table.values[1][0], {1, "exact series; published largest error 8.4 %"},
              relative(0.084));
  } else {
    const std::pair<double, double> published[] = {
        {0.70, 0.113}, {0.75, 0.084}, {0.80, 0.101}, {0.85, 0.120}, {1.0, 0.167}};
    for (const auto& [length, expected] : published)
      trial.row(fmt::format("cut-off {} cells: largest error of the normal force", length), largest_error(length),
                {expected, "independent program"}, absolute(0.03));
  }
  trial.table(table);
}

}  // namespace stresslet::validation
