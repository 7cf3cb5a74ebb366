#pragma once
/// A seal ends a file: 32 bytes that hold the length and the XXH3 checksum of all bytes before them. A format that
/// knows where its own content ends, as HDF5 does, takes no notice of it, so other programs read a sealed file as
/// usual. Checking reads the file once, at the speed of memory or disk.
#include <filesystem>

namespace stresslet {

enum class Seal {
  intact,   ///< every byte is as it was when the file was sealed
  missing,  ///< the file was never sealed, or cut short, or its end was overwritten
  broken,   ///< bytes before the seal were changed, added or lost
};

/// Reads the whole file. Throws std::filesystem::filesystem_error if it cannot be read.
Seal check_seal(const std::filesystem::path& file);
/// Throws std::filesystem::filesystem_error if the file cannot be read or written.
void add_seal(const std::filesystem::path& file);
/// Cuts the seal off a file that has one.
void remove_seal(const std::filesystem::path& file);

}  // namespace stresslet
