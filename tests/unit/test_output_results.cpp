#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <fstream>
#include <limits>
#include <random>

#include "output_samples.hpp"
#include "stresslet/base/error.hpp"
#include "stresslet/io/atomic_file.hpp"
#include "stresslet/io/hdf5.hpp"
#include "stresslet/io/results_folder.hpp"
#include "stresslet/io/seal.hpp"

namespace stresslet {
namespace {

using namespace output_samples;
using testing::AllOf;
using testing::HasSubstr;

std::string message_of(const auto& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.strain, b.strain);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.box.length, b.box.length);
  EXPECT_EQ(a.box.offset, b.box.offset);
  EXPECT_EQ(a.box.periodic_in_y, b.box.periodic_in_y);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.velocity, b.velocity);
  EXPECT_EQ(a.angular_velocity, b.angular_velocity);
  EXPECT_EQ(a.radius, b.radius);
  EXPECT_EQ(a.species, b.species);
  EXPECT_EQ(a.id, b.id);
}

/// Three commits of two samples and one snapshot each.
void write_three(const std::filesystem::path& file) {
  ResultsWriter writer = ResultsWriter::start(file, columns(), "model = \"CLM-S\"\n", provenance("run case", 2, 42));
  for (std::size_t k = 0; k < 3; ++k) {
    writer.add_sample(sample(2 * k));
    writer.add_sample(sample(2 * k + 1));
    writer.add_snapshot(snapshot(k));
    writer.set_profile({"velocity", "d shear rate", "mean velocity", {2, 3}, {0, 1, 2, 3, 4, double(k)}});
    writer.commit(checkpoint(k));
  }
}

TEST(ResultsFile, EverythingComesBackAsWritten) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  const ResultsReader reader(folder / "results.h5");
  EXPECT_EQ(reader.columns(), columns());
  ASSERT_EQ(reader.sample_count(), 6u);
  for (std::size_t column = 0; column < columns().size(); ++column)
    for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(reader.series(columns()[column].name)[k], sample(k)[column]);
  ASSERT_EQ(reader.snapshot_count(), 3u);
  for (std::size_t k = 0; k < 3; ++k) expect_same(reader.snapshot(k), snapshot(k));
  EXPECT_EQ(reader.resolved_input(), "model = \"CLM-S\"\n");
  EXPECT_EQ(reader.checkpoint(), checkpoint(2));
  EXPECT_EQ(reader.profile_names(), std::vector<std::string>{"velocity"});
  const Profile profile = reader.profile("velocity");
  EXPECT_EQ(profile.shape, (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(profile.values, (std::vector<double>{0, 1, 2, 3, 4, 2}));
  EXPECT_EQ(profile.unit, "d shear rate");
  const Provenance from = reader.provenance();
  EXPECT_EQ(from.command_line, "run case");
  EXPECT_EQ(from.threads, 2);
  EXPECT_EQ(from.seed, 42);
  EXPECT_FALSE(std::filesystem::exists(folder / "results.h5.part"));
}

TEST(ResultsFile, CheckpointKeepsEveryBit) {
  const TemporaryFolder folder;
  Checkpoint c;
  c.arrays["numbers"] = std::vector<double>{-0.0, std::numeric_limits<double>::denorm_min(), 0.1, 1e308};
  c.scalars["minus_zero"] = -0.0;
  ResultsWriter writer = ResultsWriter::start(folder / "results.h5", columns(), "", provenance("", 1, 0));
  writer.commit(c);
  const Checkpoint back = ResultsReader(folder / "results.h5").checkpoint();
  const auto &a = std::get<0>(c.arrays.at("numbers")), &b = std::get<0>(back.arrays.at("numbers"));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a[k]), std::bit_cast<std::uint64_t>(b[k]));
  EXPECT_TRUE(std::signbit(std::get<double>(back.scalars.at("minus_zero"))));
}

TEST(ResultsFile, CheckpointReplacesTheOneBefore) {
  const TemporaryFolder folder;
  ResultsWriter writer = ResultsWriter::start(folder / "results.h5", columns(), "", provenance("", 1, 0));
  writer.commit(checkpoint(0));
  Checkpoint other;
  other.arrays["x"] = std::vector<std::int32_t>{4};
  other.scalars["commits"] = 0.5;
  writer.commit(other);
  EXPECT_EQ(ResultsReader(folder / "results.h5").checkpoint(), other);
}

TEST(ResultsFile, CheckpointsAndProfilesDoNotMakeTheFileGrow) {
  const TemporaryFolder folder;
  ResultsWriter writer = ResultsWriter::start(folder / "results.h5", columns(), "", provenance("", 1, 0));
  std::uintmax_t after_ten = 0;
  for (std::size_t k = 0; k < 60; ++k) {
    writer.set_profile({"velocity", "d shear rate", "mean velocity", {20}, std::vector<double>(20, double(k))});
    writer.commit(checkpoint(k, 2000));
    if (k == 10) after_ten = std::filesystem::file_size(folder / "results.h5");
  }
  // One checkpoint is 2000 (24 + 4) bytes = 56 kB; fifty of them would be 2.8 MB.
  EXPECT_LT(std::filesystem::file_size(folder / "results.h5"), after_ten + 56000);
}

TEST(ResultsFile, AResumedRunAppends) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  for (std::size_t restart = 0; restart < 2; ++restart) {
    ResultsWriter writer =
        ResultsWriter::resume(folder / "results.h5", columns(), "strain = 2\n", provenance("restart", 1, 42));
    EXPECT_EQ(writer.sample_count(), 6 + restart);
    EXPECT_EQ(writer.snapshot_count(), 3 + restart);
    writer.add_sample(sample(6 + restart));
    writer.add_snapshot(snapshot(3 + restart));
    writer.commit(checkpoint(9));
  }
  const ResultsReader reader(folder / "results.h5");
  const std::vector<double> strain = reader.series("strain");
  ASSERT_EQ(strain.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(strain[k], sample(k)[0]);
  expect_same(reader.snapshot(4), snapshot(4));
  EXPECT_EQ(reader.provenance().command_line, "run case");
  const hdf5::File file = hdf5::File::open_read_only(folder / "results.h5");
  EXPECT_EQ(file.members("/provenance"), (std::vector<std::string>{"restart_001", "restart_002"}));
}

TEST(ResultsFile, OtherColumnsCannotResume) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  auto fewer = columns();
  fewer.pop_back();
  EXPECT_THROW(ResultsWriter::resume(folder / "results.h5", fewer, "", provenance("", 1, 0)), InputError);
}

TEST(ResultsFile, MissingFilesAreExplained) {
  const TemporaryFolder folder;
  EXPECT_THAT(message_of([&] { ResultsReader(folder / "results.h5"); }),
              AllOf(HasSubstr("results.h5"), HasSubstr("no such results file"), HasSubstr("fix:")));
}

TEST(ResultsFile, ForeignFilesAreExplained) {
  const TemporaryFolder folder;
  std::ofstream(folder / "notes.txt") << "not a results file, but long enough to look like something";
  EXPECT_THAT(message_of([&] { ResultsReader(folder / "notes.txt"); }),
              AllOf(HasSubstr("notes.txt"), HasSubstr("not a results file"), HasSubstr("fix:")));
  std::ofstream(folder / "empty.h5");
  EXPECT_THAT(message_of([&] { ResultsReader(folder / "empty.h5"); }), HasSubstr("not a results file"));
  hdf5::File other = hdf5::File::create(folder / "other.h5");
  other.write<double>("/data", std::vector<double>{1, 2, 3});
  other.close();
  EXPECT_THAT(message_of([&] { ResultsReader(folder / "other.h5"); }),
              AllOf(HasSubstr("other.h5"), HasSubstr("of another program"), HasSubstr("fix:")));
}

TEST(ResultsFile, FilesOfALaterVersionAreExplained) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  remove_seal(folder / "results.h5");
  hdf5::File file = hdf5::File::open_read_write(folder / "results.h5");
  file.set_attribute("/", "format_version", std::int32_t(1000));
  file.close();
  add_seal(folder / "results.h5");
  EXPECT_THAT(message_of([&] { ResultsReader(folder / "results.h5"); }), HasSubstr("format version is 1000"));
}

TEST(ResultsFile, EveryTruncationIsRefused) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  const std::string whole = read_whole_file(folder / "results.h5");
  for (std::size_t size = 0; size < whole.size(); size += 997) {
    std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, size);
    EXPECT_THROW(ResultsReader(folder / "cut.h5"), InputError) << "cut to " << size << " of " << whole.size();
  }
}

TEST(ResultsFile, EveryFlippedBitIsRefused) {
  const TemporaryFolder folder;
  write_three(folder / "results.h5");
  const std::string whole = read_whole_file(folder / "results.h5");
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> byte(0, whole.size() - 1);
  std::uniform_int_distribution<int> bit(0, 7);
  for (int trial = 0; trial < 400; ++trial) {
    std::string damaged = whole;
    const std::size_t place = byte(random);
    damaged[place] = char(damaged[place] ^ (1 << bit(random)));
    std::ofstream(folder / "damaged.h5", std::ios::binary) << damaged;
    EXPECT_THAT(message_of([&] { ResultsReader(folder / "damaged.h5"); }),
                AllOf(HasSubstr("damaged.h5"), HasSubstr("fix:")))
        << place;
  }
}

/// What another program changes during a run is neither built upon nor sealed as good.
TEST(ResultsFile, DamageDuringARunStopsTheNextCommit) {
  const TemporaryFolder folder;
  ResultsWriter writer = ResultsWriter::start(folder / "results.h5", columns(), "", provenance("", 1, 0));
  writer.commit(checkpoint(0));
  std::string content = read_whole_file(folder / "results.h5");
  content[content.size() / 2] ^= 1;
  std::ofstream(folder / "results.h5", std::ios::binary) << content;
  EXPECT_THROW(writer.commit(checkpoint(1)), Error);
  EXPECT_TRUE(read_whole_file(folder / "results.h5") == content);
}

TEST(ResultsFile, UnwritableTargetKeepsWhatWasCollected) {
  const TemporaryFolder folder;
  ResultsWriter writer = ResultsWriter::start(folder / "later/results.h5", columns(), "", provenance("", 1, 0));
  writer.add_sample(sample(0));
  EXPECT_THROW(writer.commit(checkpoint(0)), Error);
  std::filesystem::create_directory(folder / "later");
  writer.commit(checkpoint(0));
  EXPECT_EQ(ResultsReader(folder / "later/results.h5").series("time"), std::vector<double>{sample(0)[1]});
}

TEST(Provenance, NamesThisBuild) {
  const Provenance from = provenance("stresslet run", 3, 7);
  EXPECT_THAT(from.version, testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(from.commit, testing::MatchesRegex("[0-9a-f]{7,40}(\\+changes)?|unknown"));
  EXPECT_THAT(from.date, testing::MatchesRegex("20..-..-..T..:..:..Z"));
  EXPECT_FALSE(from.compiler.empty());
  EXPECT_THAT(from.build_flags, HasSubstr("-Wall"));
}

}  // namespace
}  // namespace stresslet
