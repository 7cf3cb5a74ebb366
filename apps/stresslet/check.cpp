#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "commands.hpp"
#include "stresslet/simulation/any_case.hpp"

namespace stresslet {

void add_check(CLI::App& app, ExitCode&) {
  struct Arguments {
    std::string file;
    std::vector<std::string> overrides;
    bool resolved = false;
  };
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "check", "Read an input, refuse what cannot be run, and print everything derived from it; runs nothing");
  command->add_option("CASE", arguments->file, "Input file")->required();
  add_overrides(*command, arguments->overrides);
  command->add_flag("--resolved", arguments->resolved, "Print the complete input with every default instead");
  command->callback([arguments] {
    const AnyCase settled = read_any_case(arguments->file, arguments->overrides);
    const std::string report = plan_report(settled);
    fmt::print("{}", arguments->resolved ? resolved_toml(settled) : report);
  });
}

}  // namespace stresslet
