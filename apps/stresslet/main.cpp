/// The command line: one subcommand a file (commands.hpp). Results go to stdout, the log to stderr; exit codes are
/// those of ExitCode in base/error.hpp.
#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "commands.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/provenance.hpp"

namespace {

constexpr const char* description =
    "Dense suspensions of rigid spheres, sheared on the microscale.\n\n"
    "  stresslet new case.toml                          a commented input to start from\n"
    "  stresslet check case.toml                        what it means: steps, limits, memory, time\n"
    "  stresslet run case.toml --output results         run it\n"
    "  stresslet restart results --set run.strain=20    go on, or go on after a stop\n"
    "  stresslet validate all --quick                   published cases beside their references\n";

constexpr const char* exit_codes =
    "Exit codes: 0 finished, 2 wrong input, 3 numerical failure during a run, 4 stopped with a checkpoint, 5 a "
    "validation outside its tolerance, 1 anything else.";

int fail(stresslet::ExitCode code, const char* message) {
  fmt::print(stderr, "stresslet: {}\n", message);
  return int(code);
}

}  // namespace

int main(int argc, char** argv) {
  spdlog::set_default_logger(spdlog::stderr_color_mt("stresslet"));
  spdlog::set_pattern("%^%l%$: %v");

  CLI::App app(description, "stresslet");
  app.set_version_flag("--version", stresslet::version_text());
  app.footer(exit_codes);
  app.require_subcommand(1);
  stresslet::ExitCode code = stresslet::ExitCode::success;
  const std::string command_line = stresslet::joined(argc, argv);
  stresslet::add_new(app, code);
  stresslet::add_check(app, code);
  stresslet::add_run(app, code, command_line);
  stresslet::add_restart(app, code, command_line);
  stresslet::add_list(app, code);
  stresslet::add_validate(app, code, command_line);
  stresslet::add_calibrate(app, command_line);

  try {
    app.parse(argc, argv);
    return int(code);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : int(stresslet::ExitCode::input);
  } catch (const stresslet::Error& error) {
    return fail(error.code(), error.what());
  } catch (const std::exception& error) {
    return fail(stresslet::ExitCode::internal, error.what());
  }
}
