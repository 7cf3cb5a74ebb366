#pragma once
/// The output folder of a run: results.h5 and, drawn from it, series.csv, particles.xyz (OVITO) and particles.xdmf
/// (ParaView). results.h5 is committed first and alone counts; the others follow and are rebuilt on a restart.
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "stresslet/io/results_file.hpp"
#include "stresslet/io/xdmf.hpp"

namespace stresslet {

inline constexpr const char* uncommitted_csv_name = "uncommitted.csv";

/// Makes the folder if needed and tries to write there. InputError if it cannot be written, or if it holds results
/// already and `force` is false. Deletes nothing: old results go at the first commit of the new run.
void prepare_output_folder(const std::filesystem::path& folder, bool force);

/// Which files to write beside results.h5.
struct OutputChoice {
  bool series_csv = true, particles_xyz = true, particles_xdmf = true;
};

class ResultsFolder {
 public:
  /// A new run in a folder that `prepare_output_folder` has accepted.
  static ResultsFolder start(std::filesystem::path folder, std::vector<Column> columns, std::string resolved_input,
                             Provenance provenance, OutputChoice choice = {});
  /// Goes on with the run in `folder`; see ResultsWriter::resume.
  static ResultsFolder resume(std::filesystem::path folder, std::vector<Column> columns, std::string resolved_input,
                              Provenance provenance, OutputChoice choice = {});

  /// One value per column, in order.
  void add_sample(std::span<const double> values);
  void add_snapshot(Snapshot snapshot);
  void set_profile(Profile profile) { writer_.set_profile(std::move(profile)); }
  /// See ResultsWriter::commit.
  void commit(const Checkpoint& checkpoint);
  /// Where a run fails: puts the samples since the last commit into uncommitted.csv, which a new run or a continuation
  /// removes. Whether there were any, and series.csv was chosen.
  bool keep_uncommitted();

  std::size_t sample_count() const { return writer_.sample_count(); }
  std::size_t snapshot_count() const { return writer_.snapshot_count(); }
  const std::filesystem::path& path() const { return folder_; }

 private:
  ResultsFolder(std::filesystem::path folder, ResultsWriter writer, OutputChoice choice);
  void rebuild_from_results();

  std::filesystem::path folder_;
  ResultsWriter writer_;
  OutputChoice choice_;
  bool old_files_ = true;  // files of an earlier run may lie in the folder
  std::string csv_, xyz_;  // text that is not in the files yet
  std::vector<XdmfStep> steps_;
  std::size_t described_steps_ = 0;  // in the XDMF file
};

}  // namespace stresslet
