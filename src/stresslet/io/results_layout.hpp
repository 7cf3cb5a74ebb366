#pragma once
/// Internal to io/results_*.cpp: names that writer and reader share.
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace stresslet::layout {

inline constexpr const char* format = "stresslet results";
inline constexpr std::int32_t format_version = 1;
inline constexpr const char* checkpoint_version = "checkpoint_format_version";

inline std::string snapshot_group(std::size_t index) { return fmt::format("/snapshots/{:06}", index); }

/// Calls `visit(name, text)` for every text of a (constant or mutable) Provenance.
template <class P, class Visit>
void for_each_text(P& from, Visit&& visit) {
  visit("version", from.version), visit("commit", from.commit), visit("compiler", from.compiler);
  visit("build_type", from.build_type), visit("build_flags", from.build_flags);
  visit("date", from.date), visit("command_line", from.command_line);
}

}  // namespace stresslet::layout
