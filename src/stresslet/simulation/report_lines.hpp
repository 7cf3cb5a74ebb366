#pragma once
/// Lines of the reports that `stresslet check` prints.
#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace stresslet {

inline std::string line(const std::string& label, const std::string& value, const std::string& remark = {}) {
  return fmt::format("  {:<28}{}\n", label, remark.empty() ? value : fmt::format("{:<22} {}", value, remark));
}

inline std::string memory_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", std::max(bytes / 1e6, 1.0)) : fmt::format("{:.1f} GB", bytes / 1e9);
}

}  // namespace stresslet
