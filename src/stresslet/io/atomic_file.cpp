#include "stresslet/io/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "stresslet/base/error.hpp"

namespace stresslet {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& attempt) {
  const std::string reason = std::strerror(errno);
  throw Error(ExitCode::internal, {path.string(), "cannot " + attempt, reason,
                                   "check the free space and the permissions there; what was committed before is "
                                   "intact, and the run can be continued with 'stresslet restart'"});
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags) : id_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (id_ < 0) fail(path, "open");
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { ::close(id_); }
  int id() const { return id_; }

 private:
  int id_;
};

void write_all(const Descriptor& file, const std::filesystem::path& path, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(file.id(), text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "write");
    text.remove_prefix(std::size_t(written));
  }
}

/// Copies inside the kernel, sharing blocks where the file system can; by std::filesystem where it cannot.
void copy_content(const std::filesystem::path& from, const std::filesystem::path& to) {
  {
    const Descriptor source(from, O_RDONLY), target(to, O_WRONLY | O_CREAT | O_TRUNC);
    ssize_t copied = 0;
    do {
      copied = ::copy_file_range(source.id(), nullptr, target.id(), nullptr, std::size_t(1) << 30, 0);
    } while (copied > 0 || (copied < 0 && errno == EINTR));
    if (copied == 0 && ::lseek(target.id(), 0, SEEK_END) == ::lseek(source.id(), 0, SEEK_END)) return;
  }
  std::error_code error;
  std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing, error);
  if (error) {
    errno = error.value();
    fail(to, "copy " + from.filename().string());
  }
}

/// Some file systems cannot force a folder to disk; the rename then still holds for every killed process.
void synchronise_folder(const std::filesystem::path& folder) {
  const int id = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0) return;
  ::fsync(id);
  ::close(id);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path target, Start start)
    : target_(std::move(target)), part_(target_.string() + ".part") {
  if (start == Start::copy_of_target)
    copy_content(target_, part_);
  else
    Descriptor(part_, O_WRONLY | O_CREAT | O_TRUNC);
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!committed_) std::filesystem::remove(part_, ignored);
}

void AtomicFile::append(std::string_view text) const { write_all(Descriptor(part_, O_WRONLY | O_APPEND), part_, text); }

void AtomicFile::commit() {
  {
    const Descriptor file(part_, O_WRONLY);
    if (::fsync(file.id()) != 0) fail(part_, "force to disk");
  }
  if (::rename(part_.c_str(), target_.c_str()) != 0) fail(target_, "replace");
  committed_ = true;
  synchronise_folder(target_.parent_path());
}

void replace_file(const std::filesystem::path& target, std::string_view text) {
  AtomicFile file(target, AtomicFile::Start::empty);
  file.append(text);
  file.commit();
}

void append_to_file(const std::filesystem::path& target, std::string_view text) {
  using Start = AtomicFile::Start;
  AtomicFile file(target, std::filesystem::exists(target) ? Start::copy_of_target : Start::empty);
  file.append(text);
  file.commit();
}

std::string read_whole_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!file || std::filesystem::is_directory(path) || (file.peek() != EOF && !(content << file.rdbuf())))
    throw InputError({path.string(), "cannot be read",
                      std::filesystem::exists(path) ? "it is a folder or protected" : "there is no such file",
                      "check the path and the permissions"});
  return content.str();
}

}  // namespace stresslet
