// A disk that fills up at any point: an error that names the file, the old file intact, nothing
// left behind; for each format.

#include <gtest/gtest.h>

#include "formats/exr/exr_writer.h"
#include "formats/hdf5/state_dump.h"
#include "formats/png/png_writer.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/io/small_files.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
using test::SmallFiles;

const std::vector<std::string> kRgb = {"R", "G", "B"};

Result<Published> write_picture(Result<std::unique_ptr<PictureFile>> file,
                                const std::vector<Field<float>>& planes) {
  if (!file) return file.error();
  if (auto written = test::write_strips(**file, planes, kRgb, 32); !written) return written.error();
  return (*file)->finish();
}

Result<Published> write(const std::string& path) {
  const auto planes = test::made_up_planes(200, 150, 3);
  if (path.ends_with(".png")) {
    PngOptions options;
    options.width = 200;
    options.height = 150;
    return write_picture(create_png(path, options), planes);
  }
  if (path.ends_with(".exr")) {
    ExrOptions options;
    options.width = 200;
    options.height = 150;
    options.channels = kRgb;
    return write_picture(create_exr(path, options), planes);
  }
  return write_state(path, test::made_up_dump(64, 48, 2, 3), {});
}

class FailedOutput : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Formats, FailedOutput, testing::Values("a.png", "a.exr", "a.h5"));

TEST_P(FailedOutput, AFullDiskLeavesTheOldFileAndNoOther) {
  const Scratch scratch;
  const std::string path = scratch.path(GetParam());
  ASSERT_TRUE(write(path));
  const auto size = std::filesystem::file_size(path);
  test::spill(path, "old");
  for (rlim_t limit = 0; limit < size; limit += size / 7) {
    {
      const SmallFiles full(limit);
      const auto result = write(path);
      ASSERT_FALSE(result) << limit << " of " << size;
      EXPECT_EQ(result.error().code, ErrorCode::kIo);
      EXPECT_EQ(result.error().message, path + ": File too large");
    }
    EXPECT_EQ(test::slurp(path), "old");
    EXPECT_EQ(scratch.files(), 1u);
  }
  const SmallFiles enough(size);
  EXPECT_TRUE(write(path));
}

TEST_P(FailedOutput, AFolderOrAMissingParentIsOneLine) {
  const Scratch scratch;
  const std::string path = scratch.path(std::string("none/") + GetParam());
  const auto orphan = write(path);
  ASSERT_FALSE(orphan);
  EXPECT_EQ(orphan.error().message, path + ": No such file or directory");
  std::filesystem::create_directory(scratch.path(GetParam()));
  const auto folder = write(scratch.path(GetParam()));
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().message, scratch.path(GetParam()) + ": Is a directory");
}

TEST_P(FailedOutput, AnAbandonedPictureLeavesNothing) {
  const Scratch scratch;
  const std::string path = scratch.path(GetParam());
  if (path.ends_with(".h5")) return;  // a dump is written in one go
  {
    PngOptions png;
    png.width = png.height = 100;
    ExrOptions exr;
    exr.width = exr.height = 100;
    exr.channels = kRgb;
    auto file = path.ends_with(".png") ? create_png(path, png) : create_exr(path, exr);
    ASSERT_TRUE(file);
    PictureStrip strip;
    strip.rows = 10;
    strip.name = kRgb;
    const auto planes = test::made_up_planes(100, 10, 3);
    for (const Field<float>& plane : planes) strip.plane.push_back(plane.view());
    ASSERT_TRUE((*file)->write(strip));
    EXPECT_EQ(scratch.files(), 1u);
  }
  EXPECT_EQ(scratch.files(), 0u);
}

}  // namespace
}  // namespace pentimento
