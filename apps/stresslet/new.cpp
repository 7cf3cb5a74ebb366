#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/simulation/case.hpp"
#include "stresslet/simulation/fluid/case.hpp"

namespace stresslet {

void add_new(CLI::App& app, ExitCode&) {
  auto file = std::make_shared<std::string>();
  auto fidelity = std::make_shared<std::string>("lubricated");
  CLI::App* command = app.add_subcommand("new", "Write a commented input file to start from");
  command->add_option("FILE", *file, "File to write; - for standard output")->required();
  command
      ->add_option("--fidelity", *fidelity,
                   "lubricated: a suspension; resolved: with the fluid in it; fluid: flow without particles")
      ->check(CLI::IsMember({"lubricated", "resolved", "fluid"}));
  command->callback([file, fidelity] {
    const std::string text =
        *fidelity == "fluid" ? new_fluid_case_template()
                             : new_case_template(*fidelity == "resolved" ? Fidelity::resolved : Fidelity::lubricated);
    if (*file == "-") {
      fmt::print("{}", text);
      return;
    }
    if (std::filesystem::exists(*file))
      throw InputError({*file, "the file exists already", "an input that somebody wrote must not be lost",
                        "choose another name, or remove it first"});
    const std::filesystem::path folder = std::filesystem::absolute(*file).parent_path();
    if (!std::filesystem::is_directory(folder))
      throw InputError({*file, "the file cannot be written", "there is no folder " + folder.string(),
                        "make the folder first, or choose another name"});
    replace_file(*file, text);
    fmt::print("{} written; next: stresslet check {}\n", *file, *file);
  });
}

}  // namespace stresslet
