#include "stresslet/io/seal.hpp"

#include <xxhash.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <memory>
#include <system_error>
#include <vector>

namespace stresslet {
namespace {

constexpr std::array<char, 16> mark{'s', 't', 'r', 'e', 's', 's', 'l', 'e', 't', ' ', 's', 'e', 'a', 'l', 'e', 'd'};

struct Trailer {
  std::array<char, 16> mark{};
  std::uint64_t length = 0, checksum = 0;
};
static_assert(sizeof(Trailer) == 32);

[[noreturn]] void fail(const std::filesystem::path& file, const char* attempt) {
  throw std::filesystem::filesystem_error(std::string("cannot ") + attempt, file,
                                          std::error_code(errno, std::generic_category()));
}

std::uint64_t checksum(const std::filesystem::path& file, std::uint64_t length) {
  constexpr std::uint64_t piece = 1 << 20;
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(), XXH3_freeState);
  XXH3_64bits_reset(state.get());
  std::ifstream in(file, std::ios::binary);
  std::vector<char> buffer(piece);
  for (std::uint64_t done = 0; done < length;) {
    const std::uint64_t count = std::min(piece, length - done);
    if (!in.read(buffer.data(), std::streamsize(count))) fail(file, "read");
    XXH3_64bits_update(state.get(), buffer.data(), count);
    done += count;
  }
  return XXH3_64bits_digest(state.get());
}

}  // namespace

Seal check_seal(const std::filesystem::path& file) {
  const std::uint64_t size = std::filesystem::file_size(file);
  Trailer trailer;
  if (size < sizeof trailer) return Seal::missing;
  std::ifstream in(file, std::ios::binary);
  std::array<char, sizeof trailer> bytes{};
  if (!in.seekg(std::streamoff(size - sizeof trailer)).read(bytes.data(), bytes.size())) fail(file, "read");
  std::memcpy(&trailer, bytes.data(), bytes.size());
  if (trailer.mark != mark) return Seal::missing;
  const std::uint64_t length = size - sizeof trailer;
  return trailer.length == length && trailer.checksum == checksum(file, length) ? Seal::intact : Seal::broken;
}

void add_seal(const std::filesystem::path& file) {
  const std::uint64_t length = std::filesystem::file_size(file);
  const Trailer trailer{mark, length, checksum(file, length)};
  std::array<char, sizeof trailer> bytes{};
  std::memcpy(bytes.data(), &trailer, bytes.size());
  std::ofstream out(file, std::ios::binary | std::ios::app);
  if (!out.write(bytes.data(), bytes.size()).flush()) fail(file, "write");
}

void remove_seal(const std::filesystem::path& file) {
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - sizeof(Trailer));
}

}  // namespace stresslet
