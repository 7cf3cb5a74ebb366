#pragma once
/// results.h5, the one file of a run:
///
///     /                    attributes format = "stresslet results", format_version
///     /series/<column>     (samples) double; attributes unit, description
///     /snapshots/000042/   attributes strain, time, box_length (3), box_offset, periodic_in_y; datasets position,
///                          velocity, angular_velocity (N, 3), radius, species, id (N)
///     /profiles/<name>     1-D or 2-D double; attributes unit, description
///     /input/resolved      text: the complete input
///     /provenance          attributes; /provenance/restart_001 ... for every continuation
///     /checkpoint/<array>  restart state; scalars are attributes of /checkpoint
///
/// After the HDF5 content stands a seal (seal.hpp). It is checked before HDF5 opens the file, whose version 1.10 may
/// crash on damaged metadata. Checking and sealing cost a commit 0.2 s of processor time per 500 MB, beside 1.6 s for
/// the copy.
///
/// A commit copies the file, adds to the copy, forces it to disk and renames it over the old one: results and restart
/// state always belong together, and a process killed at any moment loses only what came after the last commit.
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "stresslet/io/provenance.hpp"
#include "stresslet/io/results_data.hpp"

namespace stresslet {

namespace hdf5 {
class File;
}

inline constexpr const char* results_file_name = "results.h5";

/// Reads results.h5. InputError, with file, reason and fix, if it is missing, damaged, cut short or foreign.
class ResultsReader {
 public:
  explicit ResultsReader(std::filesystem::path file);
  ResultsReader(ResultsReader&&) noexcept;
  ~ResultsReader();

  std::vector<Column> columns() const;
  std::vector<double> series(const std::string& column) const;
  std::size_t sample_count() const;
  std::size_t snapshot_count() const;
  Snapshot snapshot(std::size_t index) const;
  std::vector<std::string> profile_names() const;
  Profile profile(const std::string& name) const;
  std::string resolved_input() const;
  Provenance provenance() const;
  Checkpoint checkpoint() const;

 private:
  std::filesystem::path path_;
  std::unique_ptr<hdf5::File> file_;
};

/// Collects samples, snapshots and profiles in memory and adds them to results.h5 at every commit.
class ResultsWriter {
 public:
  /// A new file; nothing is touched on disk before the first commit, which replaces an old file of that name.
  static ResultsWriter start(std::filesystem::path file, std::vector<Column> columns, std::string resolved_input,
                             Provenance provenance);
  /// Goes on with an existing file, whose input is replaced by the one of the continuation. InputError if the file
  /// cannot be read or holds other columns.
  static ResultsWriter resume(std::filesystem::path file, std::vector<Column> columns, std::string resolved_input,
                              Provenance provenance);

  /// One value per column, in order.
  void add_sample(std::span<const double> values);
  void add_snapshot(Snapshot snapshot);
  void set_profile(Profile profile);

  /// Throws Error if the file cannot be written; the last commit then still stands and nothing collected is lost.
  /// `before_replacing` runs when the new file is complete, just before it takes the place of the old one.
  void commit(const Checkpoint& checkpoint, const std::function<void()>& before_replacing = {});

  const std::vector<Column>& columns() const { return columns_; }
  /// Counts include what is not yet committed.
  std::size_t sample_count() const;
  std::size_t snapshot_count() const { return committed_snapshots_ + snapshots_.size(); }

 private:
  ResultsWriter(std::filesystem::path file, std::vector<Column> columns, Provenance provenance);
  void write_to(hdf5::File& file, const Checkpoint& checkpoint) const;

  std::filesystem::path path_;
  std::vector<Column> columns_;
  std::string resolved_input_;
  Provenance provenance_;
  bool new_file_ = true;         // no commit of this run yet, and none to continue
  bool note_provenance_ = true;  // cleared by the first commit
  std::size_t committed_samples_ = 0, committed_snapshots_ = 0;
  std::vector<std::vector<double>> samples_;  // per column
  std::vector<Snapshot> snapshots_;
  std::vector<Profile> profiles_;
};

}  // namespace stresslet
