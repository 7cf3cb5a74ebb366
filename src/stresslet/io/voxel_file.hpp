#pragma once
/// A box of voxels from a file, one byte each, not 0 meaning solid: raw bytes with x fastest, a NumPy file (.npy,
/// version 1 to 3, C order, one-byte items) of shape (nz, ny, nx), or an HDF5 file (.h5, .hdf5) with a dataset `solid`
/// of that shape.
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stresslet {

/// 0 or 1 per voxel, x fastest. Throws InputError, with `where` as the place of the request, if the file cannot be read
/// or is not of this size.
std::vector<std::uint8_t> read_voxels(const std::filesystem::path& file, const std::array<int, 3>& size,
                                      const std::string& where);

}  // namespace stresslet
