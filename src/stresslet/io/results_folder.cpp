#include "stresslet/io/results_folder.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <system_error>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"

namespace stresslet {
namespace {

constexpr const char* csv_name = "series.csv";
constexpr const char* xyz_name = "particles.xyz";
constexpr const char* xdmf_name = "particles.xdmf";
constexpr const char* beside_results[] = {csv_name,       xyz_name,     xdmf_name, uncommitted_csv_name,
                                          "summary.json", "picture.png"};

}  // namespace

void prepare_output_folder(const std::filesystem::path& folder, bool force) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!std::filesystem::is_directory(folder))
    throw InputError({folder.string(), "the output folder cannot be made",
                      std::filesystem::exists(folder) ? "there is a file of that name" : error.message(),
                      "choose another folder with --output"});
  if (!force && std::filesystem::exists(folder / results_file_name))
    throw InputError({folder.string(), "the output folder holds results already", "a run never overwrites another one",
                      "choose another folder with --output, replace the results with --force, or continue that run "
                      "with 'stresslet restart'"});
  const std::filesystem::path trial = folder / ".stresslet-trial";
  if (!std::ofstream(trial))
    throw InputError({folder.string(), "the output folder cannot be written", std::strerror(errno),
                      "check its permissions, or choose another folder with --output"});
  std::filesystem::remove(trial, error);
}

ResultsFolder::ResultsFolder(std::filesystem::path folder, ResultsWriter writer, OutputChoice choice)
    : folder_(std::move(folder)), writer_(std::move(writer)), choice_(choice) {}

ResultsFolder ResultsFolder::start(std::filesystem::path folder, std::vector<Column> columns,
                                   std::string resolved_input, Provenance from, OutputChoice choice) {
  ResultsWriter writer =
      ResultsWriter::start(folder / results_file_name, std::move(columns), std::move(resolved_input), std::move(from));
  ResultsFolder results(std::move(folder), std::move(writer), choice);
  if (choice.series_csv) results.csv_ = csv_header(results.writer_.columns());
  return results;
}

ResultsFolder ResultsFolder::resume(std::filesystem::path folder, std::vector<Column> columns,
                                    std::string resolved_input, Provenance from, OutputChoice choice) {
  ResultsWriter writer =
      ResultsWriter::resume(folder / results_file_name, std::move(columns), std::move(resolved_input), std::move(from));
  ResultsFolder results(std::move(folder), std::move(writer), choice);
  results.old_files_ = false;
  std::filesystem::remove(results.folder_ / uncommitted_csv_name);
  results.rebuild_from_results();
  return results;
}

void ResultsFolder::rebuild_from_results() {
  const ResultsReader reader(folder_ / results_file_name);
  if (choice_.series_csv) {
    std::vector<std::vector<double>> series;
    for (const Column& column : writer_.columns()) series.push_back(reader.series(column.name));
    std::string text = csv_header(writer_.columns());
    std::vector<double> row(series.size());
    for (std::size_t sample = 0; sample < reader.sample_count(); ++sample) {
      for (std::size_t k = 0; k < series.size(); ++k) row[k] = series[k].at(sample);
      text += csv_row(row);
    }
    replace_file(folder_ / csv_name, text);
  }
  std::optional<AtomicFile> xyz;
  if (choice_.particles_xyz) xyz.emplace(folder_ / xyz_name, AtomicFile::Start::empty);
  for (std::size_t k = 0; k < reader.snapshot_count(); ++k) {
    const Snapshot snapshot = reader.snapshot(k);
    steps_.push_back({snapshot.strain, snapshot.size()});
    if (xyz) xyz->append(xyz_frame(snapshot));
  }
  if (xyz) xyz->commit();
  if (choice_.particles_xdmf) replace_file(folder_ / xdmf_name, xdmf_text(steps_, results_file_name));
  described_steps_ = steps_.size();
}

void ResultsFolder::add_sample(std::span<const double> values) {
  writer_.add_sample(values);
  if (choice_.series_csv) csv_ += csv_row(values);
}

void ResultsFolder::add_snapshot(Snapshot snapshot) {
  if (choice_.particles_xyz) xyz_ += xyz_frame(snapshot);
  steps_.push_back({snapshot.strain, snapshot.size()});
  writer_.add_snapshot(std::move(snapshot));
}

void ResultsFolder::commit(const Checkpoint& checkpoint) {
  writer_.commit(checkpoint, [this] {
    if (old_files_)
      for (const char* name : beside_results) std::filesystem::remove(folder_ / name);
    old_files_ = false;
  });
  if (!csv_.empty()) append_to_file(folder_ / csv_name, csv_);
  csv_.clear();
  if (!xyz_.empty()) append_to_file(folder_ / xyz_name, xyz_);
  xyz_.clear();
  if (choice_.particles_xdmf && described_steps_ != steps_.size()) {
    replace_file(folder_ / xdmf_name, xdmf_text(steps_, results_file_name));
    described_steps_ = steps_.size();
  }
}

bool ResultsFolder::keep_uncommitted() {
  if (csv_.empty()) return false;
  replace_file(folder_ / uncommitted_csv_name, csv_header(writer_.columns()) + csv_);
  return true;
}

}  // namespace stresslet
