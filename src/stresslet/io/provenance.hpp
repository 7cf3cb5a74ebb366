#pragma once
/// Where results come from: program version, commit and build, command line and start conditions.
#include <cstdint>
#include <string>

namespace stresslet {

struct Provenance {
  std::string version, commit;  ///< commit: abbreviated hash, "+changes" if the sources differ from it
  std::string compiler, build_type, build_flags;
  std::string date;  ///< of the start, UTC, ISO 8601
  std::string command_line;
  int threads = 1;
  std::int64_t seed = 0;
};

/// Provenance of this program, now.
Provenance provenance(std::string command_line, int threads, std::int64_t seed);

}  // namespace stresslet
