#include "formats/checkpoint/plane_index.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento::checkpoint {
namespace {

using test::Scratch;

const std::vector<float> kOne = {1, 2, 3, 4}, kOther = {5, 6, 7, 8};

/// Two planes in the file of generation 4.
PlaneIndex some_planes(const Scratch& scratch) {
  PlaneIndex index;
  const auto file = SyncedFile::create(plane_file(scratch.path(""), 4));
  EXPECT_TRUE(file);
  append_plane({0, 1}, kOne, 4, **file, index);
  append_plane({3, 0}, kOther, 4, **file, index);
  EXPECT_TRUE((*file)->sync());
  return index;
}

TEST(PlaneIndex, PlanesComeBackFromWhereItSays) {
  const Scratch scratch;
  ArchiveWriter to;
  some_planes(scratch).put(to);
  ArchiveReader from(to.bytes());
  const PlaneIndex index = PlaneIndex::take(from);
  ASSERT_TRUE(from.complete());
  EXPECT_EQ(index.generations(), std::set<std::uint64_t>{4});
  PlaneFiles files(scratch.path(""), index);
  std::vector<float> out(4);
  ASSERT_TRUE(files.read({3, 0}, out));
  EXPECT_EQ(out, kOther);
  ASSERT_TRUE(files.read({0, 1}, out));
  EXPECT_EQ(out, kOne);
}

TEST(PlaneIndex, DamageIsFoundAndWhatIsMissingIsSaid) {
  const Scratch scratch;
  const PlaneIndex index = some_planes(scratch);
  std::vector<float> out(4);
  EXPECT_FALSE(PlaneFiles(scratch.path(""), index).read({1, 1}, out));
  const std::string path = plane_file(scratch.path(""), 4);
  std::string bytes = test::slurp(path);
  bytes[17] = static_cast<char>(bytes[17] ^ 1);
  test::spill(path, bytes);
  PlaneFiles files(scratch.path(""), index);
  EXPECT_TRUE(files.read({0, 1}, out));
  const Result<void> damaged = files.read({3, 0}, out);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, ErrorCode::kBadInput);
  test::spill(path, bytes.substr(0, 20));
  EXPECT_FALSE(PlaneFiles(scratch.path(""), index).read({3, 0}, out));
  std::filesystem::remove(path);
  EXPECT_FALSE(PlaneFiles(scratch.path(""), index).read({0, 1}, out));
}

TEST(PlaneIndex, ForgetsTheTilesThatItIsToldTo) {
  const Scratch scratch;
  PlaneIndex index = some_planes(scratch);
  index.forget(1);
  EXPECT_EQ(index.planes(), 2u);
  index.forget(3);
  EXPECT_EQ(index.find({3, 0}), nullptr);
  ASSERT_NE(index.find({0, 1}), nullptr);
}

}  // namespace
}  // namespace pentimento::checkpoint
