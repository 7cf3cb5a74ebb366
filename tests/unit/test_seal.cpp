#include <gtest/gtest.h>

#include <fstream>

#include "output_samples.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/seal.hpp"

namespace stresslet {
namespace {

using output_samples::TemporaryFolder;

class SealOf : public ::testing::TestWithParam<std::size_t> {
 protected:
  void write(const std::string& content) { std::ofstream(file_, std::ios::binary) << content; }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "file";
  std::string content_ = std::string(GetParam(), 'x');
};

TEST_P(SealOf, ComesAndGoesWithoutATrace) {
  write(content_);
  EXPECT_EQ(check_seal(file_), Seal::missing);
  add_seal(file_);
  EXPECT_EQ(check_seal(file_), Seal::intact);
  EXPECT_EQ(read_whole_file(file_).substr(0, GetParam()), content_);
  remove_seal(file_);
  EXPECT_EQ(read_whole_file(file_), content_);
}

TEST_P(SealOf, NoticesEveryKindOfChange) {
  write(content_);
  add_seal(file_);
  const std::string sealed = read_whole_file(file_);
  for (const std::size_t place : {std::size_t(0), sealed.size() / 2, sealed.size() - 40, sealed.size() - 10}) {
    if (place >= sealed.size()) continue;
    std::string damaged = sealed;
    damaged[place] ^= 1;
    write(damaged);
    EXPECT_NE(check_seal(file_), Seal::intact) << place;
  }
  write(sealed.substr(1));
  EXPECT_EQ(check_seal(file_), GetParam() == 0 ? Seal::missing : Seal::broken);
  write("x" + sealed);
  EXPECT_EQ(check_seal(file_), Seal::broken);
  write(sealed + "x");
  EXPECT_EQ(check_seal(file_), Seal::missing);
}

INSTANTIATE_TEST_SUITE_P(Sizes, SealOf, ::testing::Values(0, 1, 1000, (1 << 20), (1 << 20) + 7, 3 << 20));

}  // namespace
}  // namespace stresslet
