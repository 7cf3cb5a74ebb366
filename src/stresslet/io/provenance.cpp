#include "stresslet/io/provenance.hpp"

#include <fmt/chrono.h>

#include <ctime>
#include <utility>

#include "stresslet/io/build.hpp"

namespace stresslet {

Provenance provenance(std::string command_line, int threads, std::int64_t seed) {
  return {.version = build::version,
          .commit = build::commit,
          .compiler = build::compiler,
          .build_type = build::type,
          .build_flags = build::flags,
          .date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))),
          .command_line = std::move(command_line),
          .threads = threads,
          .seed = seed};
}

}  // namespace stresslet
