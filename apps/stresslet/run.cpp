#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <memory>

#include "commands.hpp"
#include "stresslet/simulation/any_case.hpp"

namespace stresslet {

namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

/// The first signal asks for a checkpoint; a second one ends the program at once.
void request_stop(int signal) {
  stop_requested = true;
  std::signal(signal, SIG_DFL);
}

void listen_for_stop(RunOptions& options) {
  options.stop = &stop_requested;
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

struct RunArguments {
  std::string file;
  std::vector<std::string> overrides;
  RunOptions options;
};

}  // namespace

void add_run(CLI::App& app, ExitCode& code, const std::string& command_line) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command =
      app.add_subcommand("run", "Run a case. Ctrl-C or SIGTERM writes a checkpoint and ends with exit code 4");
  command->add_option("CASE", arguments->file, "Input file")->required();
  command->add_option("--output", arguments->options.output, "Folder for the results")->required();
  command->add_flag("--force", arguments->options.force, "Replace results that lie there already");
  command->add_flag("--quiet", arguments->options.quiet, "No plan and no progress line");
  add_overrides(*command, arguments->overrides);
  command->callback([arguments, &code, command_line] {
    arguments->options.command_line = command_line;
    listen_for_stop(arguments->options);
    code = run_case(read_any_case(arguments->file, arguments->overrides), arguments->options);
  });
}

void add_restart(CLI::App& app, ExitCode& code, const std::string& command_line) {
  auto arguments = std::make_shared<RunArguments>();
  CLI::App* command = app.add_subcommand(
      "restart",
      "Continue a run from its last checkpoint, bit for bit; --set may change [run], as in run.strain=20 or "
      "run.end_time=20");
  command->add_option("RESULTS", arguments->file, "Folder of the run")->required();
  command->add_option(
      "--output", arguments->options.output,
      "With --set fidelity=resolved: folder of the new, resolved run that starts from the last state of "
      "a lubricated one");
  command->add_flag("--force", arguments->options.force, "Replace results that lie in --output already");
  command->add_flag("--quiet", arguments->options.quiet, "No progress line");
  add_overrides(*command, arguments->overrides);
  command->callback([arguments, &code, command_line] {
    arguments->options.command_line = command_line;
    listen_for_stop(arguments->options);
    code = restart_any_run(arguments->file, arguments->overrides, arguments->options);
  });
}

}  // namespace stresslet
