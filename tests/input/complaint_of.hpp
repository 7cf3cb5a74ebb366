#pragma once
/// The message with which an input is refused.
#include <functional>
#include <string>
#include <vector>

#include "stresslet/base/error.hpp"
#include "stresslet/simulation/case.hpp"

namespace stresslet {

/// The text of the InputError that `action` throws; empty if it throws none.
inline std::string complaint_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

inline std::string complaint_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return complaint_of([&] { read_case_text(text, "case.toml", overrides); });
}

}  // namespace stresslet
