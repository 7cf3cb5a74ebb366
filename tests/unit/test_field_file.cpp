/// Files of fields: what is written is read back, and XDMF points at what is there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "output_samples.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/field_file.hpp"

namespace stresslet {
namespace {

using ::testing::HasSubstr;

FieldFile sample(std::int64_t step) {
  FieldFile file{step, double(step) / 7, {3, 2, 4}, {0.25, 0, -0.5}, {0.5, 1, 0.125}, {}};
  file.fields.push_back({"pressure", "rho*U^2", "pressure", 1, std::vector<double>(24)});
  file.fields.push_back({"velocity", "U", "velocity", 3, std::vector<double>(72)});
  for (std::size_t k = 0; k < 24; ++k) file.fields[0].values[k] = double(k) / 3;
  for (std::size_t k = 0; k < 72; ++k) file.fields[1].values[k] = -double(k) / 9;
  return file;
}

TEST(FieldFile, ReadsBackToItself) {
  const output_samples::TemporaryFolder folder;
  const FieldFile written = sample(30);
  write_field_file(folder / "a.h5", written);
  const FieldFile read = read_field_file(folder / "a.h5");
  EXPECT_EQ(read.step, 30);
  EXPECT_EQ(read.time, written.time);
  EXPECT_EQ(read.count, written.count);
  EXPECT_EQ(read.origin, written.origin);
  EXPECT_EQ(read.spacing, written.spacing);
  ASSERT_EQ(read.fields.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read.fields[k].name, written.fields[k].name);
    EXPECT_EQ(read.fields[k].unit, written.fields[k].unit);
    EXPECT_EQ(read.fields[k].components, written.fields[k].components);
    EXPECT_EQ(read.fields[k].values, written.fields[k].values);
  }
}

TEST(FieldFile, HeadersOfAFolderStopAtAStep) {
  const output_samples::TemporaryFolder folder;
  std::filesystem::create_directories(folder / fields_folder);
  for (const std::int64_t step : {90, 30, 60})
    write_field_file(folder / fields_folder / field_file_name(step), sample(step));
  std::ofstream(folder / fields_folder / "notes.h5") << "of the user";
  const auto headers = field_headers(folder.path(), 60);
  ASSERT_EQ(headers.size(), 2u);
  EXPECT_EQ(headers[0].step, 30);
  EXPECT_EQ(headers[1].step, 60);
  EXPECT_TRUE(headers[0].fields[0].values.empty());
  std::ofstream(folder / fields_folder / "000000030.h5.part") << "unfinished";
  remove_field_files(folder.path(), 30);
  EXPECT_EQ(field_headers(folder.path(), 100).size(), 1u);
  EXPECT_FALSE(std::filesystem::exists(folder / fields_folder / "000000030.h5.part"));
  EXPECT_TRUE(std::filesystem::exists(folder / fields_folder / "notes.h5"));
}

TEST(FieldFile, XdmfNamesGridTimesAndFields) {
  const std::string text = fields_xdmf_text({sample(7), sample(14)});
  EXPECT_THAT(text, HasSubstr("<Time Value=\"1\"/>"));
  EXPECT_THAT(text, HasSubstr("<Time Value=\"2\"/>"));
  EXPECT_THAT(text, HasSubstr("TopologyType=\"3DCoRectMesh\" Dimensions=\"5 3 4\""));  // points: cells + 1, z y x
  EXPECT_THAT(text, HasSubstr(">-0.5 0 0.25</DataItem>"));
  EXPECT_THAT(text, HasSubstr(">0.125 1 0.5</DataItem>"));
  EXPECT_THAT(text,
              HasSubstr("Name=\"velocity\" AttributeType=\"Vector\" Center=\"Cell\"><DataItem Dimensions=\"4 2 3 3\""));
  EXPECT_THAT(text, HasSubstr(">fields/000000014.h5:/velocity</DataItem>"));
}

TEST(FieldFile, OtherFilesAreRefused) {
  const output_samples::TemporaryFolder folder;
  std::ofstream(folder / "a.h5") << "no HDF5";
  EXPECT_THROW(read_field_file(folder / "a.h5"), InputError);
  EXPECT_THROW(read_field_file(folder / "absent.h5"), InputError);
}

}  // namespace
}  // namespace stresslet
