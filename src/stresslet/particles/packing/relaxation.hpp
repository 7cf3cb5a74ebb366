#pragma once
/// Pushes overlapping spheres apart: minimises E = 1/2 sum (overlap)^2 over pairs and walls by the fast inertial
/// relaxation engine (FIRE; Bitzek et al. 2006, Phys. Rev. Lett. 97, 170201), with inertia proportional to the square
/// of the radius, as is the number of contacts a sphere may have.
#include <functional>

#include "stresslet/particles/packing/near_list.hpp"
#include "stresslet/particles/packing/spheres.hpp"

namespace stresslet {

struct RelaxationResult {
  double largest_overlap;  ///< relative to the centre distance at contact
  int steps;
};

class Relaxation {
 public:
  Relaxation(Spheres& spheres, double skin) : spheres_(spheres), near_(skin) {}

  /// Relaxes at `inflation` until no overlap exceeds `tolerance`, or the forces balance (jammed), or `most_steps`
  /// have passed. Reports its largest overlap now and then.
  RelaxationResult run(double inflation, double tolerance, int most_steps,
                       const std::function<void(double)>& report_overlap);

 private:
  struct Forces {
    double largest_overlap = 0, sum_of_squared_overlaps = 0, sum_of_squared_forces = 0, power = 0;
  };
  Forces compute_forces(double inflation);
  void mix_velocities(double mixing);
  void stop();
  void advance(double step, double longest_move);

  Spheres& spheres_;
  NearList near_;
  std::vector<Vec3<double>> force_, velocity_;
  std::vector<double> inverse_inertia_;
};

}  // namespace stresslet
