/// Voxels from raw bytes, NumPy and HDF5 files; wrong sizes and kinds are refused with what is needed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "output_samples.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/hdf5.hpp"
#include "stresslet/io/voxel_file.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;

const std::vector<std::uint8_t> voxels{0, 1, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 1, 1, 1, 0, 0};
const std::array<int, 3> size{4, 3, 2};

std::string bytes() { return {voxels.begin(), voxels.end()}; }

/// As numpy.save writes it: magic, version 1.0, length of the header, header padded with blanks.
std::string npy(const std::string& dictionary, const std::string& content) {
  std::string header = dictionary;
  header.resize(117, ' ');
  header += '\n';
  std::string text("\x93NUMPY\x01\x00", 8);
  text += char(header.size());
  text += '\0';
  return text + header + content;
}

class VoxelFile : public ::testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::string refusal(const std::filesystem::path& file) {
    try {
      read_voxels(file, size, "case.toml:7");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  output_samples::TemporaryFolder folder_;
};

TEST_F(VoxelFile, AllFormatsHoldTheSame) {
  EXPECT_EQ(read_voxels(write("a.raw", bytes()), size, ""), voxels);
  const std::string shape = "'fortran_order': False, 'shape': (2, 3, 4), }";
  EXPECT_EQ(read_voxels(write("a.npy", npy("{'descr': '|u1', " + shape, bytes())), size, ""), voxels);
  EXPECT_EQ(read_voxels(write("b.npy", npy("{'descr': '|b1', " + shape, bytes())), size, ""), voxels);
  {
    hdf5::File file = hdf5::File::create(folder_ / "a.h5");
    file.write<std::uint8_t>("/solid", voxels, {2, 3, 4});
  }
  EXPECT_EQ(read_voxels(folder_ / "a.h5", size, ""), voxels);
}

TEST_F(VoxelFile, WhatIsNotZeroIsSolid) {
  std::string text = bytes();
  for (char& c : text) c = c ? '\xff' : '\0';
  EXPECT_EQ(read_voxels(write("a.raw", text), size, ""), voxels);
}

TEST_F(VoxelFile, WrongSizesAreRefusedWithTheRightOne) {
  const std::string raw = refusal(write("a.raw", bytes() + "x"));
  EXPECT_THAT(raw, HasSubstr("case.toml:7: "));
  EXPECT_THAT(raw, HasSubstr("of another size: 25 bytes"));
  EXPECT_THAT(raw, HasSubstr("4 x 3 x 2 cells, so 24 bytes or shape (nz, ny, nx) = (2, 3, 4)"));
  EXPECT_THAT(refusal(write("a.npy", npy("{'descr': '|u1', 'fortran_order': False, 'shape': (4, 3, 2), }", bytes()))),
              HasSubstr("of another size: shape (4, 3, 2)"));
  EXPECT_THAT(refusal(write("b.npy", npy("{'descr': '|u1', 'fortran_order': False, 'shape': (2, 3, 4), }", "short"))),
              HasSubstr("5 bytes of content"));
}

TEST_F(VoxelFile, OtherKindsAreRefused) {
  const std::string shape = "'shape': (2, 3, 4), }";
  EXPECT_THAT(refusal(write("a.npy", npy("{'descr': '<f8', 'fortran_order': False, " + shape, bytes()))),
              HasSubstr("items are of type f8"));
  EXPECT_THAT(refusal(write("a.npy", npy("{'descr': '|u1', 'fortran_order': True, " + shape, bytes()))),
              HasSubstr("Fortran"));
  EXPECT_THAT(refusal(write("a.npy", bytes())), HasSubstr("not a NumPy file"));
  EXPECT_THAT(refusal(write("a.npy", std::string("\x93NUMPY\x01\x00\xff\xff", 10))), HasSubstr("not a NumPy file"));
  EXPECT_THAT(refusal(write("a.h5", bytes())), HasSubstr("cannot be read"));
  EXPECT_THAT(refusal(folder_ / "absent.raw"), HasSubstr("there is no such file"));
}

}  // namespace
}  // namespace stresslet
