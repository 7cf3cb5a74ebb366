#include "validation/harness/validate.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <vector>

#include "stresslet/exec/timer.hpp"
#include "stresslet/io/nearest_word.hpp"
#include "stresslet/io/results_folder.hpp"
#include "validation/harness/report.hpp"

namespace stresslet::validation {

namespace {

bool passes(const Case& what, const ValidateOptions& options) {
  const std::filesystem::path folder = options.folder_per_case ? options.output / what.id : options.output;
  prepare_output_folder(folder, true);
  Trial trial(options.quick, options.threads, options.quiet);
  const Timer timer;
  what.run(trial);
  trial.progress().finish();
  const double seconds = timer.seconds();
  write_results(folder, what, trial, seconds, provenance(options.command_line, options.threads, 0));
  fmt::print("{}  {:.1f} s, {}\n\n", table_text(what, trial), seconds, (folder / "validation.json").string());
  std::fflush(stdout);
  return trial.passes();
}

}  // namespace

ExitCode validate(std::span<const Case> chosen, const ValidateOptions& options) {
  std::vector<std::string> failed;
  for (const Case& what : chosen)
    if (!passes(what, options)) failed.emplace_back(what.id);
  if (chosen.size() > 1)
    fmt::print("{} of {} cases pass{}{}\n", chosen.size() - failed.size(), chosen.size(),
               failed.empty() ? "" : "; FAIL: ", comma_separated(failed));
  return failed.empty() ? ExitCode::success : ExitCode::disagreement;
}

}  // namespace stresslet::validation
