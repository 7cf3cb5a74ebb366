#pragma once
/// Errors that reach the user. Every message states the problem, why it is one, and the fix; input errors carry
/// the place in the input ("case.toml:12"). Each class has its own exit code, documented in docs/user-guide.md.
#include <stdexcept>
#include <string>
#include <utility>

namespace stresslet {

enum class ExitCode : int { success = 0, internal = 1, input = 2, numerical = 3, interrupted = 4, disagreement = 5 };

/// Problem, reason and fix, each a sentence or clause without a final full stop; `where` may be empty.
struct Complaint {
  std::string where;
  std::string problem;
  std::string reason;
  std::string fix;

  std::string text() const {
    std::string message = where.empty() ? "" : where + ": ";
    message += problem;
    if (!reason.empty()) message += "\n  why: " + reason;
    if (!fix.empty()) message += "\n  fix: " + fix;
    return message;
  }
};

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const Complaint& complaint) : std::runtime_error(complaint.text()), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Wrong input: found before the run starts.
class InputError : public Error {
 public:
  explicit InputError(const Complaint& complaint) : Error(ExitCode::input, complaint) {}
};

/// The numbers went wrong during a run (NaN, an unstable step, energy that does not balance).
class NumericalFailure : public Error {
 public:
  explicit NumericalFailure(const Complaint& complaint) : Error(ExitCode::numerical, complaint) {}
};

}  // namespace stresslet
