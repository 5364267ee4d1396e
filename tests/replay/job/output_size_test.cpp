#include "replay/job/output_size.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

constexpr CanvasGeometry kGrid{1024, 768, 1.0, 0.75};

void expect_size(const SizeRequest& request, int width, int height, double dpi) {
  const Result<OutputSize> size = output_size(request, kGrid);
  ASSERT_TRUE(size.ok()) << size.error().message;
  EXPECT_EQ(size->width, width);
  EXPECT_EQ(size->height, height);
  EXPECT_EQ(size->dpi, dpi);
}

SizeRequest print(const char* text, double dpi = 0) {
  SizeRequest request;
  request.print = text;
  request.dpi = dpi;
  return request;
}

TEST(OutputSize, IsTheGridUnlessAsked) {
  expect_size({}, 1024, 768, 0);
}

TEST(OutputSize, TheOtherSideFollowsTheCanvas) {
  SizeRequest width;
  width.width = 4096;
  expect_size(width, 4096, 3072, 0);
  SizeRequest height;
  height.height = 333;
  height.dpi = 72;
  expect_size(height, 444, 333, 72);
  SizeRequest scale;
  scale.scale = 0.5;
  expect_size(scale, 512, 384, 0);
}

TEST(OutputSize, ASheetHoldsTheLargestPictureOfTheCanvasShape) {
  expect_size(print("60x45cm", 300), 7087, 5315, 300);  // 60 cm = 23.622 in
  expect_size(print("24x18in", 100), 2400, 1800, 100);
  expect_size(print("600x450mm", 300), 7087, 5315, 300);
  expect_size(print("100x45cm", 300), 7087, 5315, 300);  // the height limits
}

TEST(OutputSize, IsoSheetsLieAsTheCanvasDoes) {
  // A2 is 420 x 594 mm, and lies: 4:3 in 594 x 420 is 560 x 420 mm.
  expect_size(print("A2", 300), 6614, 4961, 300);
  const Result<OutputSize> tall = output_size(print("a4"), {600, 800, 0.75, 1.0});
  EXPECT_EQ(tall->width, 2480);  // A4 is 210 x 297 mm
  EXPECT_EQ(tall->height, 3307);
}

TEST(OutputSize, TwoWaysOrNonsenseAreRefused) {
  SizeRequest two;
  two.width = 10;
  two.scale = 2;
  EXPECT_EQ(output_size(two, kGrid).error().code, ErrorCode::kUsage);
  for (const char* text : {"", "60", "60x45", "60x45 cm", "0x45cm", "A9", "60*45cm", "nanx1cm"}) {
    EXPECT_EQ(output_size(print(text), kGrid).error().code, ErrorCode::kUsage) << text;
  }
  SizeRequest huge;
  huge.scale = 1e6;
  EXPECT_EQ(output_size(huge, kGrid).error().code, ErrorCode::kLimit);
}

TEST(DetailFor, IsTheLeastAtWhichNoPixelIsSmallerThanItsCells) {
  const CanvasGeometry grid = {100, 50, 1, 1};  // cells that are not square
  EXPECT_EQ(detail_for({100, 50, 0}, grid), 1);
  EXPECT_EQ(detail_for({101, 50, 0}, grid), 2);
  EXPECT_EQ(detail_for({100, 51, 0}, grid), 2);
  EXPECT_EQ(detail_for({100, 100, 0}, grid), 2);
  EXPECT_EQ(detail_for({100, 151, 0}, grid), 4);
  EXPECT_EQ(detail_for({700, 50, 0}, grid), 7);
  EXPECT_EQ(detail_for({10, 5, 0}, grid), 1);
  EXPECT_EQ(detail_for({100000, 50, 0}, grid), 32);  // docs/cli.md: at most
  EXPECT_EQ(detail_wanted({100000, 50, 0}, grid), 1000);
}

}  // namespace
}  // namespace pentimento
