#include "validation/harness/validate.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <vector>

#include "commands.hpp"
#include "validation/cases.hpp"

namespace stresslet {

namespace {

void print_cases() {
  for (const validation::Case& c : validation::cases())
    fmt::print("{:<5}{:<62}validation/{}\n", c.id, c.title, c.folder);
}

/// The cases that were asked for, each once, in the order of the list.
std::vector<validation::Case> chosen_cases(const std::vector<std::string>& ids) {
  std::vector<bool> wanted(validation::cases().size(), false);
  for (const std::string& id : ids) {
    if (id == "all")
      wanted.assign(wanted.size(), true);
    else
      wanted[std::size_t(&validation::case_called(id) - validation::cases().data())] = true;
  }
  std::vector<validation::Case> chosen;
  for (std::size_t k = 0; k < wanted.size(); ++k)
    if (wanted[k]) chosen.push_back(validation::cases()[k]);
  return chosen;
}

}  // namespace

void add_validate(CLI::App& app, ExitCode& code, const std::string& command_line) {
  struct Arguments {
    std::vector<std::string> ids;
    validation::ValidateOptions options;
  };
  auto arguments = std::make_shared<Arguments>();
  validation::ValidateOptions& options = arguments->options;
  options.output = "results/validation";
  options.command_line = command_line;
  CLI::App* command = app.add_subcommand(
      "validate", "Run published cases beside their references; exit code 5 if a row lies outside its tolerance");
  command->add_option("ID", arguments->ids, "Cases to run, or all; list shows what each is")->required();
  command->add_option("--output", options.output,
                      "Folder for validation.json and CSV data; several cases get folders of their own in it. "
                      "Default: results/validation/ID");
  command->add_flag("--quick", options.quick, "A smaller version of each case, with tolerances of its own");
  command->add_flag("--quiet", options.quiet, "No progress line");
  command->add_option("--threads", options.threads, "Threads")->check(CLI::Range(1, 1024))->capture_default_str();
  command->callback([arguments, command, &code] {
    if (arguments->ids == std::vector<std::string>{"list"}) return print_cases();
    const std::vector<validation::Case> chosen = chosen_cases(arguments->ids);
    arguments->options.folder_per_case = chosen.size() > 1 || command->count("--output") == 0;
    code = validation::validate(chosen, arguments->options);
  });
}

}  // namespace stresslet
