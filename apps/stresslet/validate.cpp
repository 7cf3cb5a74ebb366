#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "stresslet/exec/timer.hpp"
#include "validation/cases.hpp"
#include "validation/harness/report.hpp"

namespace stresslet {

namespace {

using namespace validation;

struct Arguments {
  std::vector<std::string> ids;
  std::filesystem::path output = "results/validation";
  bool quick = false, quiet = false;
  int threads = 1;
};

void print_cases() {
  for (const Case& c : cases()) fmt::print("{:<5}{:<60}validation/{}\n", c.id, c.title, c.folder);
}

/// The cases that were asked for, each once, in the order of the list.
std::vector<Case> chosen_cases(const std::vector<std::string>& ids) {
  std::vector<bool> wanted(cases().size(), false);
  for (const std::string& id : ids) {
    if (id == "all")
      wanted.assign(wanted.size(), true);
    else
      wanted[std::size_t(&case_called(id) - cases().data())] = true;
  }
  std::vector<Case> chosen;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k]) chosen.push_back(cases()[k]);
  return chosen;
}

/// Whether all rows pass.
bool validate(const Case& what, const Arguments& arguments, const std::filesystem::path& folder,
              const std::string& command_line) {
  Trial trial(arguments.quick, arguments.threads, arguments.quiet);
  const Timer timer;
  what.run(trial);
  trial.progress().finish();
  const double seconds = timer.seconds();
  fmt::print("{}", table_text(what, trial));
  write_results(folder, what, trial, seconds, provenance(command_line, arguments.threads, 0));
  fmt::print("  {:.1f} s, {}\n\n", seconds, (folder / "validation.json").string());
  std::fflush(stdout);
  return trial.passes();
}

}  // namespace

void add_validate(CLI::App& app, ExitCode& code, const std::string& command_line) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand(
      "validate", "Run published cases and compare; exit code 5 if a row lies outside its tolerance");
  command->add_option("ID", arguments->ids, "Cases as in `stresslet validate list`; all for every one")->required();
  command->add_option("--output", arguments->output,
                      "Folder for validation.json and CSV data, by default results/validation/ID; several cases get "
                      "folders of their own in it");
  command->add_flag("--quick", arguments->quick, "A smaller version of each case, with wider tolerances");
  command->add_flag("--quiet", arguments->quiet, "No progress line");
  command->add_option("--threads", arguments->threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  command->callback([arguments, command, &code, command_line] {
    if (arguments->ids == std::vector<std::string>{"list"}) return print_cases();
    const std::vector<Case> chosen = chosen_cases(arguments->ids);
    const bool own_folders = chosen.size() > 1 || command->count("--output") == 0;
    std::string failed;
    for (const Case& c : chosen)
      if (!validate(c, *arguments, own_folders ? arguments->output / c.id : arguments->output, command_line))
        failed += " " + std::string(c.id);
    if (chosen.size() > 1)
      fmt::print("{} of {} cases pass{}{}\n", chosen.size() - std::size_t(std::ranges::count(failed, ' ')),
                 chosen.size(), failed.empty() ? "" : "; FAIL:", failed);
    if (!failed.empty()) code = ExitCode::disagreement;
  });
}

}  // namespace stresslet
