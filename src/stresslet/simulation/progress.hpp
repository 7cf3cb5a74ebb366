#pragma once
/// Progress on stderr: one line that renews itself on a terminal, a line now and then elsewhere.
#include <string>

#include "stresslet/exec/timer.hpp"

namespace stresslet {

class Progress {
 public:
  explicit Progress(bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress() { finish(); }

  /// Whether enough time has passed for another line; the caller then makes it.
  bool due() const { return !quiet_ && since_.seconds() >= interval_; }
  void show(const std::string& line);
  /// Ends the self-renewing line.
  void finish();

 private:
  bool quiet_, terminal_, shown_ = false;
  double interval_;
  Timer since_;
};

/// "45 s", "12 min", "3.4 h".
std::string duration_text(double seconds);

}  // namespace stresslet
