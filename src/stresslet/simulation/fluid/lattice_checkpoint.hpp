#pragma once
/// The populations of a run in a file of their own: results.h5 is copied at every commit, and they may be large.
///
/// Each commit writes populations-<step>.h5, then results.h5, whose checkpoint names the step, then removes the file of
/// the commit before. A process killed at any moment leaves results.h5 and the populations that belong to it.
#include <cstdint>
#include <filesystem>
#include <vector>

namespace stresslet {

void write_populations(const std::filesystem::path& results, std::int64_t step, const std::vector<double>& populations);
/// InputError if they are missing or damaged.
std::vector<double> read_populations(const std::filesystem::path& results, std::int64_t step);
/// Removes all such files, parts of unfinished ones included, except that of `step`.
void remove_other_populations(const std::filesystem::path& results, std::int64_t step);

}  // namespace stresslet
