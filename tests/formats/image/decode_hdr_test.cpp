// Radiance HDR: the pixels of OpenCV's decoder where a file is sound, one line where it is not.

#include <gtest/gtest.h>

#include <random>

#include "formats/image/read_image.h"
#include "tests/formats/image/by_opencv.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

constexpr const char* kHead = "#?RADIANCE\n# made up\nEXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\n";

std::string size_line(int width, int height) {
  return "-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

/// Codes of all kinds: black, the smallest and the largest exponent, equal neighbours.
std::string codes_of(int pixels) {
  std::mt19937 random(7);
  std::string codes;
  for (int i = 0; i < pixels; ++i) {
    if (i > 0 && random() % 3 != 0) {
      codes += codes.substr(codes.size() - 4);
      continue;
    }
    constexpr int kExponents[] = {0, 1, 9, 10, 128, 136, 254, 255};
    for (int c = 0; c < 3; ++c) codes.push_back(static_cast<char>(3 + random() % 253));
    codes.push_back(static_cast<char>(kExponents[random() % 8]));
  }
  return codes;
}

/// A row of codes as runs of each channel, of equal codes and of others by turns.
std::string runs_of(const std::string& codes) {
  const std::size_t width = codes.size() / 4;
  std::string out = "\2\2";
  out.push_back(static_cast<char>(width >> 8));
  out.push_back(static_cast<char>(width & 255));
  for (std::size_t c = 0; c < 4; ++c)
    for (std::size_t x = 0; x < width;) {
      std::size_t n = 1;
      while (x + n < width && n < 127 && codes[4 * (x + n) + c] == codes[4 * x + c]) ++n;
      if (n > 2) {
        out.push_back(static_cast<char>(128 + n));
        out.push_back(codes[4 * x + c]);
      } else {
        n = std::min<std::size_t>(width - x, 5);
        out.push_back(static_cast<char>(n));
        for (std::size_t i = 0; i < n; ++i) out.push_back(codes[4 * (x + i) + c]);
      }
      x += n;
    }
  return out;
}

std::string picture_of_runs(int width, int height) {
  const std::string codes = codes_of(width * height);
  std::string bytes = kHead + size_line(width, height);
  const auto row = static_cast<std::size_t>(4 * width);
  for (std::size_t at = 0; at < codes.size(); at += row) bytes += runs_of(codes.substr(at, row));
  return bytes;
}

class DecodeHdr : public testing::Test {
 protected:
  std::string file(const std::string& bytes) {
    test::spill(path_, bytes);
    return path_;
  }
  std::string problem(const std::string& bytes) { return test::problem_with(file(bytes)); }
  void expect_as_by_opencv(const std::string& bytes) {
    const Result<Image> image = read_image(file(bytes));
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->format, "hdr");
    EXPECT_EQ(image->bits, 32);
    EXPECT_TRUE(image->stored_float);
    test::expect_as_by_opencv(*image, path_);
  }

  const test::Scratch scratch_;
  const std::string path_ = scratch_.path("a.hdr");
};

TEST_F(DecodeHdr, GivesTheBitsThatOpenCvGives) {
  for (const int width : {1, 7, 8, 300}) {
    SCOPED_TRACE(width);
    expect_as_by_opencv(kHead + size_line(width, 5) + codes_of(5 * width));
  }
  for (const int width : {8, 129, 700}) {
    SCOPED_TRACE(width);
    expect_as_by_opencv(picture_of_runs(width, 5));
  }
  // Rows of runs, then flat ones to the end.
  expect_as_by_opencv(kHead + size_line(40, 3) + runs_of(codes_of(40)) + codes_of(80));
}

TEST_F(DecodeHdr, TheProbesOfTheTestsAreRead) {
  const std::string path = std::string(PENTIMENTO_SOURCE_DIR) + "/tests/data/probes/studio.hdr";
  const Result<Image> image = read_image(path);
  ASSERT_TRUE(image) << image.error().message;
  test::expect_as_by_opencv(*image, path);
}

TEST_F(DecodeHdr, EveryTruncationIsOneLine) {
  for (const std::string& whole :
       {picture_of_runs(20, 4), kHead + size_line(5, 4) + codes_of(20)}) {
    for (std::size_t n = 2; n < whole.size(); ++n) {
      const Error problem = test::quiet_problem(file(whole.substr(0, n)));
      ASSERT_EQ(problem.code, ErrorCode::kBadInput) << n;
      ASSERT_NE(problem.message.find("not whole"), std::string::npos) << problem.message;
    }
  }
}

TEST_F(DecodeHdr, SaysWhichRowIsDamaged) {
  const std::string head = kHead + size_line(20, 2), row = runs_of(codes_of(20));
  EXPECT_EQ(problem(head + row + row.substr(0, 30)), "row 1 of pixels is not whole");
  EXPECT_EQ(problem(head + "\2\2" + std::string("\0\x15", 2) + row),
            "row 0 of pixels says that it has 21 pixels of 20");
  const std::string start = head + "\2\2" + std::string("\0\x14", 2);
  EXPECT_EQ(problem(start + "\x95x"), "row 0 of pixels has a run of 21 where 20 are left");
  EXPECT_EQ(problem(start + "\x8Fx\x06yyyyyy"), "row 0 of pixels has a run of 6 where 5 are left");
  EXPECT_EQ(problem(start + std::string("\0x", 2)),
            "row 0 of pixels has a run of 0 where 20 are left");
}

TEST_F(DecodeHdr, SaysWhatTheHeaderLacks) {
  const std::string pixel = "\x80\x40\x20\x82";
  EXPECT_EQ(problem("#?RADIANCE\n\n-Y 1 +X 1\n" + pixel),
            "the header has no line FORMAT=32-bit_rle_rgbe");
  EXPECT_EQ(problem("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n" + pixel),
            "the header has no line FORMAT=32-bit_rle_rgbe");
  for (const char* size : {"+X 1 -Y 1", "+Y 1 +X 1", "-Y 1 +X", "-Y  +X 1", "-Y 1 +X 1x",
                           "-Y 99999999999999999999 +X 1"})
    EXPECT_EQ(problem(kHead + std::string(size) + "\n" + pixel),
              "the header has no line of the form -Y HEIGHT +X WIDTH")
        << size;
  EXPECT_EQ(problem("#?RADIANCE\n" + std::string(1 << 16, 'x')), "the header has no end");
  EXPECT_EQ(problem(kHead + size_line(0, 1) + pixel), "0 x 1 pixels");
}

TEST_F(DecodeHdr, LimitsHoldBeforeMemoryIsTaken) {
  const Error problem = test::quiet_problem(file(kHead + size_line(60000, 60000)));
  EXPECT_EQ(problem.code, ErrorCode::kLimit);
  EXPECT_EQ(problem.message, path_ + ": 60000 x 60000 pixels, the limit is 134217728 in all");
}

}  // namespace
}  // namespace pentimento
