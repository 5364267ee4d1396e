#include "replay/film/even_sides.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

constexpr CanvasGeometry kCanvas = {80, 40, 0.4, 0.2};

PictureChoice film() {
  PictureChoice picture;
  picture.outputs = {"still.png", "film.mp4"};
  return picture;
}

TEST(EvenSides, OnlyFilmsNeedThem) {
  PictureChoice picture;
  picture.outputs = {"still.png"};
  EXPECT_TRUE(check_even_sides(picture, {709, 531, 0}, kCanvas));
  EXPECT_TRUE(check_even_sides(film(), {640, 480, 0}, kCanvas));
}

TEST(EvenSides, TheLineSaysWhichWidthGivesThem) {
  // 709 is odd, 710 is 355 high; of 708 and 712 the smaller is proposed.
  for (const int width : {709, 710}) {
    const Result<void> odd = check_even_sides(film(), {width, 355, 0}, kCanvas);
    ASSERT_FALSE(odd);
    EXPECT_EQ(odd.error().code, ErrorCode::kUsage);
    EXPECT_EQ(odd.error().message, "-o film.mp4: a film's sides are even, this one has " +
                                       std::to_string(width) +
                                       " x 355 pixels; --width 708 gives 708 x 354");
  }
  const Result<OutputSize> given = output_size({708, {}, {}, {}, 0}, kCanvas);
  ASSERT_TRUE(given);
  EXPECT_TRUE(check_even_sides(film(), *given, kCanvas));
}

TEST(EvenSides, ATinyFilmMayGrow) {
  const Result<void> odd = check_even_sides(film(), {1, 1, 0}, kCanvas);
  ASSERT_FALSE(odd);
  EXPECT_NE(odd.error().message.find("; --width 4 gives 4 x 2"), std::string::npos)
      << odd.error().message;
}

TEST(EvenSides, OfACropTheCropIsNamed) {
  PictureChoice picture = film();
  picture.crop = {10, 20, 101, 50};
  const Result<void> odd = check_even_sides(picture, {640, 480, 0}, kCanvas);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().message,
            "-o film.mp4: a film's sides are even, this one has 101 x 50 pixels; --crop "
            "10,20,100,50 would do");
  picture.crop = {10, 20, 100, 50};
  EXPECT_TRUE(check_even_sides(picture, {641, 481, 0}, kCanvas));
}

}  // namespace
}  // namespace pentimento
