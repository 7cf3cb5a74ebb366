#include "stresslet/simulation/run_parts.hpp"

#include <fmt/format.h>

namespace stresslet {

namespace {

/// Keeps the rows since the last commit; what became of them, for a message. Never throws in place of the failure.
std::string fate_of_uncommitted_rows(ResultsFolder& results) {
  const std::string file = (results.path() / uncommitted_csv_name).string();
  try {
    return results.keep_uncommitted() ? "; later rows of the series in " + file : "";
  } catch (const Error&) {
    return "; later rows of the series are lost, " + file + " could not be written";
  }
}

}  // namespace

void commit_before_running(const std::function<void()>& commit) {
  try {
    commit();
  } catch (const Error& error) {
    throw InputError({"", error.what(), "", ""});
  }
}

ExitCode finish_or_explain(ResultsFolder& results, std::string_view start, const std::function<ExitCode()>& finish,
                           const std::function<std::string()>& committed) {
  try {
    return finish();
  } catch (const NumericalFailure& failure) {
    const std::string folder = results.path().string();
    const std::string rest = fate_of_uncommitted_rows(results);
    throw NumericalFailure(
        {"",
         fmt::format("{}\n  kept: all results up to {}{}. 'stresslet restart {}' goes on from there with the same "
                     "physics and time step; a new run can start from {}",
                     failure.what(), committed(), rest, folder, start),
         "", ""});
  }
}

void refuse_changed_physics(const std::vector<std::string>& overrides, std::span<const std::string_view> changeable,
                            std::string_view instead) {
  for (const std::string& assignment : overrides) {
    const std::string key = assignment.substr(0, assignment.find('='));
    if (std::find(changeable.begin(), changeable.end(), key) == changeable.end())
      throw InputError({"--set " + assignment, fmt::format("{} cannot be changed by a restart", key),
                        "the series would mix two different runs and its means would mean nothing",
                        fmt::format("{}; a restart may change {}", instead, fmt::join(changeable, ", "))});
  }
}

}  // namespace stresslet
