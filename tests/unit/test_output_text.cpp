#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "output_samples.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/csv.hpp"
#include "stresslet/io/extended_xyz.hpp"

namespace stresslet {
namespace {

using namespace output_samples;
using testing::AllOf;
using testing::HasSubstr;

class TextFiles : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& content) const {
    std::ofstream(folder_ / "input.txt", std::ios::binary) << content;
    return folder_ / "input.txt";
  }
  std::string csv_message(const std::string& content) const {
    try {
      read_csv(file(content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  std::string xyz_message(const std::string& content) const {
    try {
      read_last_xyz_frame(file(content));
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  TemporaryFolder folder_;
};

TEST_F(TextFiles, CsvTakesTheUsualVariants) {
  for (const char* content :
       {"x,radius[d]\n1,0.5\n-2e3,.25\n", "# sizes\r\nx ; radius[d]\r\n1; 0.5\r\n\r\n-2e3;.25 # last\r\n",
        "x\tradius[d]\n1\t0.5\n-2e3\t.25", "\xEF\xBB\xBFx radius[d]\n  1   0.5\n-2e3 .25\n",
        "\"x\",\"radius[d]\"\n+1,+0.5\n-2000,0.25\n"}) {
    const CsvTable table = read_csv(file(content));
    EXPECT_EQ(table.names, (std::vector<std::string>{"x", "radius"})) << content;
    EXPECT_EQ(table.units, (std::vector<std::string>{"", "d"})) << content;
    EXPECT_EQ(table.column("x"), (std::vector<double>{1, -2000})) << content;
    EXPECT_EQ(table.column("radius"), (std::vector<double>{0.5, 0.25})) << content;
  }
}

TEST_F(TextFiles, CsvErrorsNameFileAndLine) {
  EXPECT_THAT(csv_message("x,y\n1,2\n3,abc\n"), AllOf(HasSubstr("input.txt:3"), HasSubstr("'abc' in column 'y'")));
  EXPECT_THAT(csv_message("x,y\n# note\n1,nan\n"), AllOf(HasSubstr("input.txt:3"), HasSubstr("finite")));
  EXPECT_THAT(csv_message("x,y\n1,inf\n"), HasSubstr("finite"));
  EXPECT_THAT(csv_message("x,y\n1,1e999\n"), HasSubstr("finite"));
  EXPECT_THAT(csv_message("x,y\n1,2,3\n"), AllOf(HasSubstr("input.txt:2"), HasSubstr("3 values")));
  EXPECT_THAT(csv_message("x,y\n1,\n"), HasSubstr("'' in column 'y'"));
  EXPECT_THAT(csv_message("1,2\n3,4\n"), AllOf(HasSubstr("input.txt:1"), HasSubstr("header line is missing")));
  EXPECT_THAT(csv_message("x,x\n3,4\n"), HasSubstr("twice"));
  EXPECT_THAT(csv_message("x,\n3,4\n"), HasSubstr("no name"));
  EXPECT_THAT(csv_message("x,y\n"), HasSubstr("no numbers"));
  EXPECT_THAT(csv_message(""), HasSubstr("no numbers"));
  EXPECT_THROW(read_csv(folder_ / "absent.csv"), InputError);
  EXPECT_THROW(read_csv(folder_.path()), InputError);
}

TEST_F(TextFiles, CsvNamesTheColumnsThereAre) {
  const CsvTable table = read_csv(file("x,y\n1,2\n"));
  EXPECT_FALSE(table.has("radius"));
  try {
    table.column("radius");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("'radius'"), HasSubstr("x, y")));
  }
}

TEST_F(TextFiles, XyzFrameIsWhatOvitoReads) {
  Snapshot s = snapshot(0, 1);
  s.position = {0.25, 0.5, 0.75};
  s.velocity = {1, 0, -1};
  s.angular_velocity = {0, 0, -0.5};
  s.box = {{4, 6, 8}, 3, true};  // an offset of 3 in a box of 4 is one of -1 to the nearest image
  EXPECT_EQ(xyz_frame(s),
            "1\n"
            "Lattice=\"4 0 0 -1 6 0 0 0 8\" Origin=\"0 0 0\" pbc=\"T T T\" "
            "Properties=id:I:1:species:I:1:pos:R:3:radius:R:1:velo:R:3:angular_velocity:R:3 strain=0 time=0\n"
            "0 0 0.25 0.5 0.75 0.5 1 0 -1 0 0 -0.5\n");
  s.box.periodic_in_y = false;
  EXPECT_THAT(xyz_frame(s), AllOf(HasSubstr("pbc=\"T F T\""), HasSubstr("4 0 0 0 6 0 0 0 8")));
}

TEST_F(TextFiles, XyzRoundTripTakesTheLastFrame) {
  const Snapshot last = snapshot(4);
  const XyzFrame frame = read_last_xyz_frame(file(xyz_frame(snapshot(3)) + xyz_frame(last)));
  EXPECT_EQ(frame.strain, last.strain);
  EXPECT_EQ(frame.time, last.time);
  ASSERT_TRUE(frame.box);
  EXPECT_EQ(frame.box->length, last.box.length);
  EXPECT_DOUBLE_EQ(frame.box->offset, last.box.offset);
  EXPECT_TRUE(frame.box->periodic_in_y);
  EXPECT_EQ(frame.position, last.position);
  EXPECT_EQ(frame.velocity, last.velocity);
  EXPECT_EQ(frame.angular_velocity, last.angular_velocity);
  EXPECT_EQ(frame.radius, last.radius);
  EXPECT_EQ(frame.species, last.species);
  EXPECT_EQ(frame.id, last.id);
  EXPECT_EQ(frame.first_line, 12u);  // 2 + 7 lines of the first frame, 2 lines on top of the second
}

TEST_F(TextFiles, XyzTakesPlainAndForeignFiles) {
  const XyzFrame plain = read_last_xyz_frame(file("2\nany comment\nLarge 1 2 3\nSmall 4 5 6\n\n"));
  EXPECT_EQ(plain.position, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(plain.species, (std::vector<std::int32_t>{0, 1}));
  EXPECT_TRUE(plain.radius.empty() && plain.id.empty() && !plain.box && !plain.strain);
  const XyzFrame foreign = read_last_xyz_frame(file(
      "1\r\nProperties=charge:R:1:pos:R:3:radius:R:1 pbc=\"T F T\" Lattice=\"4 0 0 0 5 0 0 0 6\"\r\n9 1 2 3 0.5\r\n"));
  EXPECT_EQ(foreign.position, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(foreign.radius, std::vector<double>{0.5});
  EXPECT_FALSE(foreign.box->periodic_in_y);
}

TEST_F(TextFiles, XyzErrorsNameFileAndLine) {
  const std::string properties = "Properties=pos:R:3:radius:R:1\n";
  EXPECT_THAT(xyz_message("x\n" + properties + "1 2 3 4\n"), AllOf(HasSubstr("input.txt:1"), HasSubstr("'x'")));
  EXPECT_THAT(xyz_message("0\n" + properties), HasSubstr("input.txt:1"));
  EXPECT_THAT(xyz_message(""), HasSubstr("input.txt:1"));
  EXPECT_THAT(xyz_message("2\n" + properties + "1 2 3 4\n"), HasSubstr("1 of 2 particles"));
  EXPECT_THAT(xyz_message("1\n" + properties + "1 2 3\n"), AllOf(HasSubstr("input.txt:3"), HasSubstr("3 values")));
  EXPECT_THAT(xyz_message("1\n" + properties + "1 2 nan 4\n"), AllOf(HasSubstr("input.txt:3"), HasSubstr("'nan'")));
  EXPECT_THAT(xyz_message("1\nProperties=radius:R:1\n4\n"), HasSubstr("pos:R:3"));
  EXPECT_THAT(xyz_message("1\nProperties=pos:R\n4\n"), HasSubstr("malformed"));
  EXPECT_THAT(xyz_message("1\nProperties=pos:R:3 Lattice=\"1 0 0 0 1\"\n1 2 3\n"), HasSubstr("nine numbers"));
  EXPECT_THAT(xyz_message("1\nProperties=pos:R:3 Lattice=\"1 0 0 0 1 0 0.5 0 1\"\n1 2 3\n"), HasSubstr("sheared box"));
  EXPECT_THAT(xyz_message("1\nProperties=pos:R:3 Lattice=\"1 0 0\n1 2 3\n"), HasSubstr("not closed"));
}

}  // namespace
}  // namespace stresslet
