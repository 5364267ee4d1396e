#include "formats/import/recording_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "formats/log/stream/log_start.h"
#include "tests/formats/scratch.h"

namespace pentimento::sketch {
namespace {

const std::string kTable = std::string(PENTIMENTO_TEST_DATA) + "/recordings/tables/OilPaint.csv.gz";

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
void write(const std::string& path, std::string_view bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

TEST(RecordingFile, IsUnpacked) {
  const Result<std::string> table = read_recording(kTable);
  ASSERT_TRUE(table) << table.error().message;
  EXPECT_TRUE(table->starts_with("mirror,stroke,t_s,u,v"));
  EXPECT_FALSE(log::starts_like_a_log(kTable));
  const test::Scratch scratch;
  write(scratch.path("plain.dat"), "0 1 2 1\n");
  EXPECT_EQ(*read_recording(scratch.path("plain.dat")), "0 1 2 1\n");
}

TEST(RecordingFile, ThatIsDamagedIsRefusedByName) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.gz"), packed = bytes_of(kTable);
  for (std::size_t percent = 1; percent < 100; ++percent) {
    write(path, packed.substr(0, packed.size() * percent / 100));
    const Result<std::string> read = read_recording(path);
    ASSERT_FALSE(read) << percent;
    EXPECT_EQ(read.error().code, ErrorCode::kBadInput);
    EXPECT_EQ(read.error().message, path + ": the packed bytes end too early");
  }
  std::string damaged = packed;
  damaged.replace(damaged.size() / 2, 9, "pentiment");
  write(path, damaged);
  EXPECT_EQ(read_recording(path).error().message, path + ": the gzip data are damaged");
  EXPECT_EQ(read_recording(scratch.path("none")).error().code, ErrorCode::kIo);
}

// A file of holes: it takes no room on the disk.
TEST(RecordingFile, IsNoLargerThanTheLimit) {
  const test::Scratch scratch;
  const std::string path = scratch.path("holes.dat");
  write(path, "");
  std::filesystem::resize_file(path, static_cast<std::uintmax_t>(kMostRecordingBytes) + 1);
  const Result<std::string> read = read_recording(path);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kLimit);
  EXPECT_EQ(read.error().message, path + ": larger than 67108864 bytes");
}

}  // namespace
}  // namespace pentimento::sketch
