#include "replay/output/output_set.h"

#include <gtest/gtest.h>

#include "formats/image/read_image.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

/// The codes of channel `c` of a PNG.
Field<float> codes(const std::string& path, std::size_t c) {
  Result<Image> image = read_image(path, {SampleMeaning::kRaw, {}});
  EXPECT_TRUE(image) << image.error().message;
  return std::move(image->plane[c]);
}

class Cropped : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Dither, Cropped, testing::Bool());

TEST_P(Cropped, IsTheCutOfTheWholePicturePixelForPixel) {
  const JobFolder folder;
  RenderJob whole = folder.job({"whole.png"}), part = folder.job({"part.png"});
  whole.picture.dither = part.picture.dither = GetParam();
  // Odd offsets, different from each other and from any period of tiles or noise.
  part.picture.crop = {19, 7, 43, 31};
  test::rendered(whole);
  const JobReport report = test::rendered(part);
  EXPECT_EQ(report.outputs.front().width, 43);
  EXPECT_EQ(report.outputs.front().height, 31);
  EXPECT_EQ(folder.says("part.png", "picture"), "80 x 60");  // of which it is a part
  for (std::size_t c = 0; c < 3; ++c) {
    const Field<float> all = codes(folder.path("whole.png"), c);
    const Field<float> cut = codes(folder.path("part.png"), c);
    ASSERT_EQ(cut.width(), 43);
    ASSERT_EQ(cut.height(), 31);
    for (int y = 0; y < 31; ++y)
      for (int x = 0; x < 43; ++x) ASSERT_EQ(cut(x, y), all(x + 19, y + 7)) << x << "," << y;
  }
}

TEST(OutputSet, ATwicePlannedNameIsRefused) {
  const JobFolder folder;
  RenderJob job = folder.job({"a.png", "a.depth.png"});
  job.picture.aovs = {"depth"};
  const auto twice = render(job, Control());
  ASSERT_FALSE(twice);
  EXPECT_EQ(twice.error().code, ErrorCode::kUsage);
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.png")));
}

TEST(WrittenSize, ACropLiesWithinThePicture) {
  PictureChoice choice;
  const OutputSize whole = {100, 80, 300};
  const auto size = [&](std::array<int, 4> crop) {
    choice.crop = crop;
    return written_size(choice, whole);
  };
  EXPECT_EQ(written_size(choice, whole)->width, 100);
  EXPECT_EQ(size({0, 0, 100, 80})->height, 80);
  EXPECT_EQ(size({90, 70, 10, 10})->width, 10);
  EXPECT_EQ(size({90, 70, 10, 10})->dpi, 300);
  for (const std::array<int, 4>& crop : {std::array<int, 4>{91, 70, 10, 10},
                                         {90, 71, 10, 10},
                                         {-1, 0, 10, 10},
                                         {0, -1, 10, 10},
                                         {0, 0, 0, 10},
                                         {0, 0, 10, 0},
                                         {2147483647, 0, 1, 1}}) {
    const auto refused = size(crop);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::kUsage);
  }
}

}  // namespace
}  // namespace pentimento
