#pragma once
/// Averages over the planes across one axis, kept for every time at which they were taken.
#include <vector>

#include "stresslet/io/results_file.hpp"
#include "stresslet/simulation/fluid/flow_field.hpp"
#include "stresslet/simulation/fluid/plan.hpp"

namespace stresslet {

class PlaneAverages {
 public:
  PlaneAverages(const FluidPlan& plan, Axis axis) : plan_(plan), axis_(axis) {}

  void add(const FlowField& field, std::int64_t step);
  bool empty() const { return time_.empty(); }
  double last_time() const { return time_.back(); }

  /// /profiles/position (cells), time (times), and velocity_x, velocity_y, velocity_z, pressure (times, cells).
  std::vector<Profile> profiles() const;
  /// Goes on where the results of an earlier part of the run end.
  void restore(const ResultsReader& reader);

 private:
  const FluidPlan& plan_;
  Axis axis_;
  std::vector<double> time_;
  std::vector<double> values_[4];  // velocity_x, velocity_y, velocity_z, pressure
};

}  // namespace stresslet
