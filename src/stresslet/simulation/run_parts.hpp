#pragma once
/// What runs of every fidelity share: when to commit, what a failure says, what a restart may change.
#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/exec/timer.hpp"
#include "stresslet/io/results_folder.hpp"

namespace stresslet {

/// Tells when the next commit is due: not before `interval` seconds, and so that commits take a small share of the
/// time.
class CommitClock {
 public:
  explicit CommitClock(double interval) : interval_(interval) {}
  /// Whether a commit is due if it takes as long as the last one.
  bool due() const { return since_.seconds() >= std::max(interval_, cost_ / largest_share); }
  /// Commits, with everything that a commit writes.
  void run(const std::function<void()>& commit) {
    const Timer timer;
    commit();
    cost_ = timer.seconds();
    since_.restart();
  }
  /// Seconds of the last commit.
  double cost() const { return cost_; }

 private:
  static constexpr double largest_share = 0.02;  // of the wall time
  double interval_;
  double cost_ = 0;
  Timer since_;
};

/// The first commit, before the first step: what cannot be written, or was damaged, is wrong input.
void commit_before_running(const std::function<void()>& commit);

/// Runs `finish`. Where it fails numerically, the samples since the last commit go to a file of their own, and the
/// message says what is kept: `committed` up to when ("strain 2"), `start` what a new run can start from.
ExitCode finish_or_explain(ResultsFolder& results, std::string_view start, const std::function<ExitCode()>& finish,
                           const std::function<std::string()>& committed);

/// Throws InputError for an override of a key that is not `changeable`. `instead` says how to get another run.
void refuse_changed_physics(const std::vector<std::string>& overrides, std::span<const std::string_view> changeable,
                            std::string_view instead);

}  // namespace stresslet
