#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "commands.hpp"
#include "stresslet/io/provenance.hpp"

namespace stresslet {

std::string version_text() {
  const Provenance p = provenance("", 1, 0);
  return fmt::format("stresslet {} (commit {}, {}, {} {})", p.version, p.commit, p.compiler, p.build_type,
                     p.build_flags);
}

std::string joined(int argc, char** argv) {
  std::string text;
  for (int k = 0; k < argc; ++k) text += (k ? " " : "") + std::string(argv[k]);
  return text;
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command
      .add_option("--set", overrides,
                  "Override an input key, as in --set suspension.solid_fraction=0.55; KEY= removes it. May be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

}  // namespace stresslet
