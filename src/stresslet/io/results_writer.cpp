#include <fmt/format.h>

#include <algorithm>

#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/hdf5.hpp"
#include "stresslet/io/results_file.hpp"
#include "stresslet/io/results_layout.hpp"
#include "stresslet/io/seal.hpp"

namespace stresslet {
namespace {

void write_header(hdf5::File& file, const std::vector<Column>& columns, const std::string& resolved_input) {
  file.set_attribute("/", "format", std::string(layout::format));
  file.set_attribute("/", "format_version", layout::format_version);
  for (const char* group : {"/series", "/snapshots", "/profiles", "/provenance", "/checkpoint"})
    file.create_group(group);
  for (const Column& column : columns) {
    const std::string path = "/series/" + column.name;
    file.create_extendible<double>(path);
    file.set_attribute(path, "unit", column.unit);
    file.set_attribute(path, "description", column.description);
  }
  std::string names;
  for (const Column& column : columns) names += (names.empty() ? "" : " ") + column.name;
  file.set_attribute("/series", "order", names);
  file.write_text("/input/resolved", resolved_input);
}

void write_provenance(hdf5::File& file, const std::string& group, const Provenance& from) {
  layout::for_each_text(from,
                        [&](const char* name, const std::string& text) { file.set_attribute(group, name, text); });
  file.set_attribute(group, "threads", std::int32_t(from.threads));
  file.set_attribute(group, "seed", from.seed);
}

void write_snapshot(hdf5::File& file, const std::string& group, const Snapshot& snapshot) {
  file.create_group(group);
  file.set_attribute(group, "strain", snapshot.strain);
  file.set_attribute(group, "time", snapshot.time);
  file.set_attribute<double>(group, "box_length", std::span<const double>(snapshot.box.length));
  file.set_attribute(group, "box_offset", snapshot.box.offset);
  file.set_attribute(group, "periodic_in_y", std::int32_t(snapshot.box.periodic_in_y));
  const std::size_t n = snapshot.size();
  file.write<double>(group + "/position", snapshot.position, {n, 3});
  file.write<double>(group + "/velocity", snapshot.velocity, {n, 3});
  file.write<double>(group + "/angular_velocity", snapshot.angular_velocity, {n, 3});
  file.write(group + "/radius", snapshot.radius);
  file.write(group + "/species", snapshot.species);
  file.write(group + "/id", snapshot.id);
}

void write_profile(hdf5::File& file, const Profile& profile) {
  const std::string path = "/profiles/" + profile.name;
  file.write<double>(path, profile.values, profile.shape);
  const auto describe = [&](const std::string& name, const std::string& text) {  // rewriting would make the file grow
    if (!file.has_attribute(path, name) || file.text_attribute(path, name) != text)
      file.set_attribute(path, name, text);
  };
  describe("unit", profile.unit);
  describe("description", profile.description);
}

void write_checkpoint(hdf5::File& file, const Checkpoint& checkpoint) {
  const std::string group = "/checkpoint";
  for (const std::string& name : file.members(group))
    if (!checkpoint.arrays.contains(name)) file.remove(group + "/" + name);
  for (const std::string& name : file.attribute_names(group))
    if (!checkpoint.scalars.contains(name)) file.remove_attribute(group, name);
  file.set_attribute(group, layout::checkpoint_version, checkpoint.format_version);
  for (const auto& [name, array] : checkpoint.arrays)
    std::visit([&, path = group + "/" + name](const auto& values) { file.write(path, values); }, array);
  for (const auto& [name, scalar] : checkpoint.scalars)
    std::visit([&, key = name](auto value) { file.set_attribute(group, key, value); }, scalar);
}

/// Opens the copy of a sealed file to add to it; it must be sealed again.
hdf5::File open_sealed(const std::filesystem::path& original, const std::filesystem::path& copy) {
  if (check_seal(copy) != Seal::intact)
    throw Error(ExitCode::internal,
                {original.string(), "the results file was changed while the run went on",
                 "its checksum does not fit any more, and what is added to a damaged file may be lost",
                 "let no other program write to it, not even h5py in a mode other than 'r', and run the case again"});
  remove_seal(copy);
  return hdf5::File::open_read_write(copy);
}

}  // namespace

ResultsWriter::ResultsWriter(std::filesystem::path file, std::vector<Column> columns, Provenance from)
    : path_(std::move(file)), columns_(std::move(columns)), provenance_(std::move(from)), samples_(columns_.size()) {}

ResultsWriter ResultsWriter::start(std::filesystem::path file, std::vector<Column> columns, std::string resolved_input,
                                   Provenance from) {
  ResultsWriter writer(std::move(file), std::move(columns), std::move(from));
  writer.resolved_input_ = std::move(resolved_input);
  return writer;
}

ResultsWriter ResultsWriter::resume(std::filesystem::path file, std::vector<Column> columns, std::string resolved_input,
                                    Provenance from) {
  ResultsWriter writer(std::move(file), std::move(columns), std::move(from));
  writer.resolved_input_ = std::move(resolved_input);
  const ResultsReader reader(writer.path_);
  if (reader.columns() != writer.columns_)
    throw InputError({writer.path_.string(), "its time series has other columns than this run writes",
                      "it was written by another version of stresslet or with another choice of columns",
                      "continue with the version that wrote it (attribute 'version' of /provenance), or start anew"});
  writer.new_file_ = false;
  writer.committed_samples_ = reader.sample_count();
  writer.committed_snapshots_ = reader.snapshot_count();
  return writer;
}

std::size_t ResultsWriter::sample_count() const {
  return committed_samples_ + (samples_.empty() ? 0 : samples_[0].size());
}

void ResultsWriter::add_sample(std::span<const double> values) {
  if (values.size() != columns_.size()) throw std::logic_error("a sample needs one value per column");
  for (std::size_t k = 0; k < values.size(); ++k) samples_[k].push_back(values[k]);
}

void ResultsWriter::add_snapshot(Snapshot snapshot) { snapshots_.push_back(std::move(snapshot)); }

void ResultsWriter::set_profile(Profile profile) {
  std::erase_if(profiles_, [&](const Profile& old) { return old.name == profile.name; });
  profiles_.push_back(std::move(profile));
}

void ResultsWriter::write_to(hdf5::File& file, const Checkpoint& checkpoint) const {
  if (new_file_) write_header(file, columns_, resolved_input_);
  if (note_provenance_) {
    std::string group = "/provenance";
    if (!new_file_) {
      file.create_group(group = fmt::format("/provenance/restart_{:03}", file.members(group).size() + 1));
      file.remove("/input/resolved");
      file.write_text("/input/resolved", resolved_input_);
    }
    write_provenance(file, group, provenance_);
  }
  for (std::size_t k = 0; k < columns_.size(); ++k) file.append<double>("/series/" + columns_[k].name, samples_[k]);
  for (std::size_t k = 0; k < snapshots_.size(); ++k)
    write_snapshot(file, layout::snapshot_group(committed_snapshots_ + k), snapshots_[k]);
  for (const Profile& profile : profiles_) write_profile(file, profile);
  write_checkpoint(file, checkpoint);
}

void ResultsWriter::commit(const Checkpoint& checkpoint, const std::function<void()>& before_replacing) {
  AtomicFile atomic(path_, new_file_ ? AtomicFile::Start::empty : AtomicFile::Start::copy_of_target);
  const auto fail = [&](const char* reason) {
    throw Error(ExitCode::internal, {path_.string(), "the results cannot be written", reason,
                                     "check the free space there; the last commit is intact"});
  };
  try {
    hdf5::File file = new_file_ ? hdf5::File::create(atomic.part()) : open_sealed(path_, atomic.part());
    write_to(file, checkpoint);
    file.close();
    add_seal(atomic.part());
  } catch (const hdf5::Failure& failure) {
    fail(failure.what());
  } catch (const std::filesystem::filesystem_error& failure) {
    fail(failure.what());
  }
  if (before_replacing) before_replacing();
  atomic.commit();
  committed_samples_ = sample_count();
  committed_snapshots_ = snapshot_count();
  for (auto& column : samples_) column.clear();
  snapshots_.clear();
  profiles_.clear();
  new_file_ = note_provenance_ = false;
}

}  // namespace stresslet
