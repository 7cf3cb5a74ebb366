#pragma once
/// One line of a validation table: a measured quantity beside an independent reference, and the verdict.
#include <cmath>
#include <string>

namespace stresslet::validation {

/// What the error of a row may be: relative to the reference or absolute, bounded on both sides.
struct Tolerance {
  bool relative;
  double lowest, highest;
};

/// |value / reference - 1| <= bound.
inline Tolerance relative(double bound) { return {true, -bound, bound}; }
/// |value - reference| <= bound.
inline Tolerance absolute(double bound) { return {false, -bound, bound}; }

struct Reference {
  double value;
  std::string source;
};

struct Row {
  std::string quantity;
  Reference reference;
  double value;
  Tolerance tolerance;

  double error() const {
    const double difference = value - reference.value;
    return tolerance.relative ? difference / std::abs(reference.value) : difference;
  }
  /// False for a value that is no number.
  bool passes() const { return error() >= tolerance.lowest && error() <= tolerance.highest; }
};

}  // namespace stresslet::validation
