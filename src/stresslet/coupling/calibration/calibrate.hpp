#pragma once
/// Lengths of a sub-grid law from measured pairs. One length decides one mode each: the normal length the squeezing
/// entry of the resistance matrix, the sliding length those of sliding and rolling, the spin length that of spinning.
/// Each is found alone, as the least sum of the fourth powers of the relative errors over all points: what is asked of
/// a correction is a bound on its error, and squares let a few places on the grid go beyond it.
#include <functional>
#include <string>
#include <vector>

#include "stresslet/coupling/calibration/pair_measurement.hpp"
#include "stresslet/coupling/subgrid/subgrid_resistance.hpp"

namespace stresslet {

/// One pair to measure, and the words for its direction.
struct CalibrationPoint {
  std::string direction;
  PairPlacement placement;
};

struct CalibrationPlan {
  double cells_across = 10;  ///< diameter of the smaller sphere
  double radius_ratio = 1;
  int edge = 50;                                   ///< of the periodic cube
  std::vector<double> gaps{0.05, 0.2, 0.5, 1, 2};  ///< cells
  int random_directions = 1;  ///< besides aligned (on and between cells), face and space diagonal; per gap
};
std::vector<CalibrationPoint> calibration_points(const CalibrationPlan& plan);

/// Resistance matrix of the four motions with the correction of the law `law` added.
Eigen::Matrix4d corrected_resistance(const PairMeasurement& measurement, const std::string& law,
                                     const SubgridLengths& lengths, const SubgridRange& range);

/// corrected/exact - 1 of squeeze, slide, roll, spin.
std::array<double, 4> corrected_errors(const PairMeasurement& measurement, const std::string& law,
                                       const SubgridLengths& lengths, const SubgridRange& range);

/// Sets one of `lengths`, within [0, 2] cells and to 1e-5, to where the fourth powers of the errors that `visit_errors`
/// passes on for given lengths add up to the least.
using ErrorVisitor = std::function<void(double)>;
void fit_length(SubgridLengths& lengths, double SubgridLengths::*length,
                const std::function<void(const SubgridLengths&, const ErrorVisitor&)>& visit_errors);

SubgridLengths fit_lengths(const std::vector<PairMeasurement>& measurements, const std::string& law,
                           const SubgridRange& range);

}  // namespace stresslet
