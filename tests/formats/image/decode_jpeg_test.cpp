// JPEG: the pixels of OpenCV's decoder where a file is sound, one line where it is not.

#include <gtest/gtest.h>

#include "core/optics/srgb.h"
#include "formats/image/read_image.h"
#include "tests/formats/image/by_opencv.h"
#include "tests/formats/image/made_up_jpeg.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::jpeg_of;
using test::JpegKind;

class DecodeJpeg : public testing::Test {
 protected:
  std::string file(const std::string& bytes) {
    test::spill(path_, bytes);
    return path_;
  }
  Result<Image> stored(const std::string& bytes) {
    return read_image(file(bytes), {SampleMeaning::kRaw, {}});
  }

  const test::Scratch scratch_;
  const std::string path_ = scratch_.path("a.jpg");
};

/// Of a JPEG's header: the bytes of a segment with its mark; empty if there is none.
std::string segment(const std::string& bytes, unsigned char mark) {
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[at + i]); };
    const std::size_t length = 2 + static_cast<std::size_t>(byte(2) << 8 | byte(3));
    if (byte(1) == mark) return bytes.substr(at, length);
    if (byte(1) == 0xDA) break;
    at += length;
  }
  return {};
}

TEST_F(DecodeJpeg, GivesTheBitsThatOpenCvGives) {
  const std::vector<JpegKind> kinds = {
      {},
      {.width = 1, .height = 1},
      {.given = JCS_GRAYSCALE, .stored = JCS_GRAYSCALE},
      {.stored = JCS_RGB, .by_adobe = true},
      {.progressive = true},
      {.restart_rows = 1},
      {.given = JCS_CMYK, .stored = JCS_CMYK, .by_adobe = true},
      {.given = JCS_CMYK, .stored = JCS_YCCK, .by_adobe = true, .progressive = true}};
  for (const JpegKind& kind : kinds) {
    const Result<Image> image = stored(jpeg_of(kind));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, "jpeg");
    EXPECT_EQ(image->bits, 8);
    EXPECT_FALSE(image->stored_float);
    test::expect_as_by_opencv(*image, path_);
  }
}

TEST_F(DecodeJpeg, LightIsWhatSrgbSaysOfTheStoredValue) {
  const std::string path = file(jpeg_of({}));
  const Result<Image> raw = read_image(path, {SampleMeaning::kRaw, {}});
  const Result<Image> light = read_image(path);
  ASSERT_TRUE(raw && light);
  for (std::size_t c = 0; c < 3; ++c)
    for (int x = 0; x < raw->width; ++x)
      EXPECT_EQ(light->plane[c](x, 9),
                static_cast<float>(srgb_to_linear(static_cast<double>(raw->plane[c](x, 9)))));
}

TEST_F(DecodeJpeg, ThePicturesOfTheManualAreRead) {
  const std::string path =
      std::string(PENTIMENTO_SOURCE_DIR) + "/docs/pictures/scheme-thin-paint.jpg";
  const Result<Image> image = read_image(path, {SampleMeaning::kRaw, {}});
  ASSERT_TRUE(image) << image.error().message;
  test::expect_as_by_opencv(*image, path);
}

// A camera that was held on its side says so in Exif. The picture is taken as it is stored.
TEST_F(DecodeJpeg, TheOrientationIsNotLookedAt) {
  const std::string tag_of_6("\x12\x01\x03\0\x01\0\0\0\x06\0\0\0", 12);
  const std::string exif =
      std::string("Exif\0\0II*\0\x08\0\0\0\x01\0", 16) + tag_of_6 + std::string(4, '\0');
  const Result<Image> turned = stored(jpeg_of({.exif = exif}));
  ASSERT_TRUE(turned) << turned.error().message;
  EXPECT_EQ(turned->width, 45);
  test::expect_as_by_opencv(*turned, path_);
}

TEST_F(DecodeJpeg, InksWithoutAdobesMarkAreAmountsOfInk) {
  const std::string bytes = jpeg_of({.given = JCS_CMYK, .stored = JCS_CMYK});
  const std::string marked = jpeg_of({.given = JCS_CMYK, .stored = JCS_CMYK, .by_adobe = true});
  const Result<Image> inks = stored(bytes);
  ASSERT_TRUE(inks) << inks.error().message;
  const Result<Image> bare = stored(marked);
  ASSERT_TRUE(bare) << bare.error().message;
  // At the corner all four codes are 0 but for what the compression rounds: no ink, or all of it.
  EXPECT_GT(inks->plane[0](0, 0), 0.9f);
  EXPECT_LT(bare->plane[0](0, 0), 0.1f);
}

TEST_F(DecodeJpeg, WithoutTablesOfCodesTheUsualOnesHold) {
  const std::string bytes = jpeg_of({});
  std::string bare = bytes;
  for (std::string table; !(table = segment(bare, 0xC4)).empty();)
    bare.erase(bare.find(table), table.size());
  ASSERT_LT(bare.size(), bytes.size());
  const Result<Image> with = stored(bytes), without = stored(bare);
  ASSERT_TRUE(with && without);
  for (int x = 0; x < with->width; ++x) EXPECT_EQ(with->plane[1](x, 20), without->plane[1](x, 20));
}

TEST_F(DecodeJpeg, EveryTruncationIsOneLine) {
  for (const bool progressive : {false, true}) {
    const std::string whole = jpeg_of({.progressive = progressive});
    for (std::size_t n = 3; n<whole.size(); n += n + 40> whole.size() ? 1 : 7) {
      const Error problem = test::quiet_problem(file(whole.substr(0, n)));
      EXPECT_EQ(problem.code, ErrorCode::kBadInput) << n << " " << problem.message;
    }
    EXPECT_EQ(test::problem_with(file(whole.substr(0, whole.size() / 2))),
              "Premature end of JPEG file");
  }
}

TEST_F(DecodeJpeg, DamageIsNeverMoreThanOneLine) {
  const std::string whole = jpeg_of({.restart_rows = 1});
  int found = 0;
  for (std::size_t at = 2; at < whole.size(); at += 3) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
    found += test::quiet_problem(file(damaged)).message != "read without an error" ? 1 : 0;
  }
  // The format has no checksums: some changes only change colours.
  EXPECT_GT(found, static_cast<int>(whole.size()) / 3 / 4);
}

TEST_F(DecodeJpeg, AFewBytesBeforeTheEndMarkArePadding) {
  std::string padded = jpeg_of({});
  padded.insert(padded.size() - 2, 16, '\0');
  EXPECT_TRUE(stored(padded));
  // The decoder has looked ahead at up to eight of them, and does not count these.
  padded.insert(padded.size() - 2, 9, '\0');
  const std::string said = test::problem_with(file(padded));
  EXPECT_TRUE(said.starts_with("Corrupt JPEG data: ") &&
              said.ends_with(" extraneous bytes before marker 0xd9"))
      << said;
}

TEST_F(DecodeJpeg, ScansAreCounted) {
  JpegKind grey{.given = JCS_GRAYSCALE, .stored = JCS_GRAYSCALE};
  grey.scans = test::scans_of_each_coefficient(1);
  const Result<Image> many = stored(jpeg_of(grey));
  ASSERT_TRUE(many) << many.error().message;
  test::expect_as_by_opencv(*many, path_);
  grey.scans = test::scans_of_each_coefficient(2);
  const Error problem = test::quiet_problem(file(jpeg_of(grey)));
  EXPECT_EQ(problem.code, ErrorCode::kLimit);
  EXPECT_EQ(problem.message, path_ + ": more than 100 scans, the limit");
}

TEST_F(DecodeJpeg, LimitsHoldBeforeMemoryIsTaken) {
  ImageReadOptions few;
  few.limits.max_pixels = 45 * 34 - 1;
  const std::string bytes = jpeg_of({});
  const Error problem = test::quiet_problem(file(bytes), few);
  EXPECT_EQ(problem.code, ErrorCode::kLimit);
  EXPECT_EQ(problem.message, path_ + ": 45 x 34 pixels, the limit is 1529 in all");
  // The same with a header that promises 65500 x 65500.
  std::string huge = bytes;
  const std::size_t frame = huge.find(segment(huge, 0xC0));
  for (const std::size_t side : {frame + 5, frame + 7}) huge.replace(side, 2, "\xFF\xDC");
  EXPECT_EQ(test::quiet_problem(file(huge)).code, ErrorCode::kLimit);
}

TEST_F(DecodeJpeg, TwoChannelsAreRefused) {
  EXPECT_EQ(test::problem_with(file(jpeg_of({.given = JCS_UNKNOWN, .stored = JCS_UNKNOWN}))),
            "2 channels are not supported");
}

TEST_F(DecodeJpeg, WhatIsMissingIsSaid) {
  EXPECT_EQ(read_image(scratch_.path("none.jpg")).error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento
