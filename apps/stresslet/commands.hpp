#pragma once
/// The subcommands. Each `add_` describes one to CLI11; its callback sets `code`.
#include <CLI/App.hpp>
#include <string>

#include "stresslet/base/error.hpp"

namespace stresslet {

void add_new(CLI::App& app, ExitCode& code);
void add_check(CLI::App& app, ExitCode& code);
void add_run(CLI::App& app, ExitCode& code, const std::string& command_line);
void add_restart(CLI::App& app, ExitCode& code, const std::string& command_line);
void add_list(CLI::App& app, ExitCode& code);
void add_validate(CLI::App& app, ExitCode& code, const std::string& command_line);
void add_calibrate(CLI::App& app, const std::string& command_line);

/// Version, commit and build.
std::string version_text();

/// The command line as one text.
std::string joined(int argc, char** argv);

/// The option --set KEY=VALUE, any number of times.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

}  // namespace stresslet
