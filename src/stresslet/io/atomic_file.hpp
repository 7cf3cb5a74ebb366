#pragma once
/// Files that are replaced in one step. The new content is written to NAME.part in the same folder, forced to disk
/// and renamed over NAME; a process killed at any moment leaves the old or the new file, never a mixture.
#include <filesystem>
#include <string>
#include <string_view>

namespace stresslet {

class AtomicFile {
 public:
  enum class Start { empty, copy_of_target };

  /// Makes NAME.part, empty or as a copy of the present file (copy-on-write where the file system can). An old
  /// NAME.part is overwritten. Throws Error.
  AtomicFile(std::filesystem::path target, Start start);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Removes NAME.part unless `commit` succeeded.
  ~AtomicFile();

  /// Where to write; the writer must have closed it before `commit`.
  const std::filesystem::path& part() const { return part_; }
  void append(std::string_view text) const;
  /// Puts the new content in place. Throws Error, and then the old file still stands.
  void commit();

 private:
  std::filesystem::path target_, part_;
  bool committed_ = false;
};

/// Replaces the file by `text`.
void replace_file(const std::filesystem::path& target, std::string_view text);
/// Adds `text` at the end; makes the file if there is none.
void append_to_file(const std::filesystem::path& target, std::string_view text);
/// The content of a file; InputError if it cannot be read.
std::string read_whole_file(const std::filesystem::path& path);

}  // namespace stresslet
