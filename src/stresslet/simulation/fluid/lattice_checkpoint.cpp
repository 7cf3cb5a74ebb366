#include "stresslet/simulation/fluid/lattice_checkpoint.hpp"

#include <fmt/format.h>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/hdf5.hpp"

namespace stresslet {

namespace {

constexpr const char* prefix = "populations-";
constexpr const char* dataset = "/populations";

std::string file_name(std::int64_t step) { return fmt::format("{}{:09}.h5", prefix, step); }

}  // namespace

void write_populations(const std::filesystem::path& results, std::int64_t step,
                       const std::vector<double>& populations) {
  AtomicFile atomic(results / file_name(step), AtomicFile::Start::empty);
  try {
    hdf5::File file = hdf5::File::create(atomic.part());
    file.write(dataset, populations);
    file.close();
  } catch (const hdf5::Failure& failure) {
    throw Error(ExitCode::internal, {(results / file_name(step)).string(), "the checkpoint cannot be written",
                                     failure.what(), "check the free space there; the last commit is intact"});
  }
  atomic.commit();
}

std::vector<double> read_populations(const std::filesystem::path& results, std::int64_t step) {
  const std::filesystem::path path = results / file_name(step);
  if (!std::filesystem::is_regular_file(path))
    throw InputError({path.string(), "the populations of the checkpoint are missing",
                      "results.h5 names this file, and it is not there", "put it back, or run the case again"});
  try {
    return hdf5::File::open_read_only(path).read<double>(dataset);
  } catch (const hdf5::Failure& failure) {
    throw InputError({path.string(), "the populations of the checkpoint are damaged", failure.what(),
                      "use a copy of the folder, or run the case again"});
  }
}

void remove_other_populations(const std::filesystem::path& results, std::int64_t step) {
  std::vector<std::filesystem::path> others;
  for (const auto& entry : std::filesystem::directory_iterator(results)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with(prefix) && name != file_name(step)) others.push_back(entry.path());
  }
  for (const auto& file : others) std::filesystem::remove(file);
}

}  // namespace stresslet
