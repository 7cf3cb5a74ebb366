#include <sstream>

#include "stresslet/base/error.hpp"
#include "stresslet/io/hdf5.hpp"
#include "stresslet/io/results_file.hpp"
#include "stresslet/io/results_layout.hpp"
#include "stresslet/io/seal.hpp"

namespace stresslet {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& problem, const std::string& reason,
                         const std::string& fix) {
  throw InputError({path.string(), problem, reason, fix});
}

/// Runs `read`; a failure inside HDF5 means that the file is damaged.
template <class Read>
auto guarded(const std::filesystem::path& path, Read&& read) {
  try {
    return read();
  } catch (const hdf5::Failure& failure) {
    refuse(path, "the results file is damaged", failure.what(), "use a copy of the file, or run the case again");
  }
}

/// HDF5 1.10 may crash on damaged metadata, so it must never see any.
void check_before_opening(const std::filesystem::path& path) {
  const Seal seal = check_seal(path);
  if (seal == Seal::missing)
    refuse(
        path, "the results file is damaged, or of another program",
        "it lacks the checksum with which stresslet ends its files: it was cut short, written to by another program, "
        "or never written by stresslet",
        "use a copy of the file, or run the case again");
  if (seal == Seal::broken)
    refuse(path, "the results file is damaged", "its content does not fit the checksum at its end",
           "use a copy of the file, or run the case again");
}

}  // namespace

ResultsReader::ResultsReader(std::filesystem::path path) : path_(std::move(path)) {
  if (!std::filesystem::is_regular_file(path_))
    refuse(path_, "there is no such results file", "the run has not written any results, or the path is wrong",
           "give the output folder of a run, the one that holds results.h5");
  if (!hdf5::File::has_signature(path_))
    refuse(path_, "this is not a results file", "it does not begin as an HDF5 file does",
           "give the results.h5 that stresslet wrote; if this is it, use a copy or run the case again");
  check_before_opening(path_);
  guarded(path_, [&] {
    file_ = std::make_unique<hdf5::File>(hdf5::File::open_read_only(path_));
    const auto version = file_->attribute<std::int32_t>("/", "format_version");
    if (version > layout::format_version)
      refuse(path_, fmt::format("its format version is {}", version),
             fmt::format("this stresslet reads versions up to {}", layout::format_version),
             "use the version of stresslet that wrote it");
    for (const char* part : {"/series", "/snapshots", "/profiles", "/provenance", "/checkpoint", "/input/resolved"})
      if (!file_->contains(part)) throw hdf5::Failure(fmt::format("{} is missing", part));
  });
}

ResultsReader::ResultsReader(ResultsReader&&) noexcept = default;
ResultsReader::~ResultsReader() = default;

std::vector<Column> ResultsReader::columns() const {
  return guarded(path_, [&] {
    std::istringstream names(file_->text_attribute("/series", "order"));
    std::vector<Column> columns;
    for (std::string name; names >> name;)
      columns.push_back({name, file_->text_attribute("/series/" + name, "unit"),
                         file_->text_attribute("/series/" + name, "description")});
    return columns;
  });
}

std::vector<double> ResultsReader::series(const std::string& column) const {
  return guarded(path_, [&] { return file_->read<double>("/series/" + column); });
}

std::size_t ResultsReader::sample_count() const {
  return guarded(path_, [&] {
    const auto names = file_->members("/series");
    return names.empty() ? 0 : file_->shape("/series/" + names[0]).at(0);
  });
}

std::size_t ResultsReader::snapshot_count() const {
  return guarded(path_, [&] { return file_->members("/snapshots").size(); });
}

Snapshot ResultsReader::snapshot(std::size_t index) const {
  return guarded(path_, [&] {
    const std::string group = layout::snapshot_group(index);
    Snapshot s;
    s.strain = file_->attribute<double>(group, "strain");
    s.time = file_->attribute<double>(group, "time");
    const auto length = file_->attribute_array<double>(group, "box_length");
    if (length.size() != 3) throw hdf5::Failure(group + " has no three box lengths");
    s.box = {{length[0], length[1], length[2]},
             file_->attribute<double>(group, "box_offset"),
             file_->attribute<std::int32_t>(group, "periodic_in_y") != 0};
    s.position = file_->read<double>(group + "/position");
    s.velocity = file_->read<double>(group + "/velocity");
    s.angular_velocity = file_->read<double>(group + "/angular_velocity");
    s.radius = file_->read<double>(group + "/radius");
    s.species = file_->read<std::int32_t>(group + "/species");
    s.id = file_->read<std::int32_t>(group + "/id");
    const std::size_t n = s.size();
    if (s.position.size() != 3 * n || s.velocity.size() != 3 * n || s.angular_velocity.size() != 3 * n ||
        s.radius.size() != n || s.species.size() != n)
      throw hdf5::Failure(group + " has arrays of unequal length");
    return s;
  });
}

std::vector<std::string> ResultsReader::profile_names() const {
  return guarded(path_, [&] { return file_->members("/profiles"); });
}

Profile ResultsReader::profile(const std::string& name) const {
  return guarded(path_, [&] {
    const std::string path = "/profiles/" + name;
    return Profile{name, file_->text_attribute(path, "unit"), file_->text_attribute(path, "description"),
                   file_->shape(path), file_->read<double>(path)};
  });
}

std::string ResultsReader::resolved_input() const {
  return guarded(path_, [&] { return file_->read_text("/input/resolved"); });
}

Provenance ResultsReader::provenance() const {
  return guarded(path_, [&] {
    Provenance from;
    layout::for_each_text(
        from, [&](const char* name, std::string& text) { text = file_->text_attribute("/provenance", name); });
    from.threads = file_->attribute<std::int32_t>("/provenance", "threads");
    from.seed = file_->attribute<std::int64_t>("/provenance", "seed");
    return from;
  });
}

Checkpoint ResultsReader::checkpoint() const {
  return guarded(path_, [&] {
    using hdf5::Kind;
    const std::string group = "/checkpoint";
    Checkpoint checkpoint;
    checkpoint.format_version = file_->attribute<std::int32_t>(group, layout::checkpoint_version);
    for (const std::string& name : file_->members(group)) {
      const std::string path = group + "/" + name;
      switch (file_->kind(path)) {
        case Kind::float64:
          checkpoint.arrays[name] = file_->read<double>(path);
          break;
        case Kind::int32:
          checkpoint.arrays[name] = file_->read<std::int32_t>(path);
          break;
        case Kind::int64:
          checkpoint.arrays[name] = file_->read<std::int64_t>(path);
          break;
        default:
          throw hdf5::Failure(path + " has a type that no checkpoint holds");
      }
    }
    for (const std::string& name : file_->attribute_names(group)) {
      if (name == layout::checkpoint_version) continue;
      if (file_->attribute_kind(group, name) == Kind::float64)
        checkpoint.scalars[name] = file_->attribute<double>(group, name);
      else
        checkpoint.scalars[name] = file_->attribute<std::int64_t>(group, name);
    }
    return checkpoint;
  });
}

}  // namespace stresslet
