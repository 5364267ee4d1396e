#include "replay/film/even_sides.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

constexpr CanvasGeometry kCanvas = {80, 60, 0.4, 0.3};

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
  const Result<void> odd = check_even_sides(film(), {709, 532, 0}, kCanvas);
  ASSERT_FALSE(odd);
  EXPECT_EQ(odd.error().code, ErrorCode::kUsage);
  // 708 would be 531 high, 710 is 532.5, rounded to 533; 707 and 711 are odd, 706 is 529.5: 530.
  EXPECT_EQ(odd.error().message,
            "-o film.mp4: a film's sides are even, this one has 709 x 532 pixels; --width 706 "
            "gives 706 x 530");
  const Result<OutputSize> given = output_size({706, {}, {}, {}, 0}, kCanvas);
  ASSERT_TRUE(given);
  EXPECT_TRUE(check_even_sides(film(), *given, kCanvas));
}

TEST(EvenSides, ATinyFilmMayGrow) {
  const Result<void> odd = check_even_sides(film(), {1, 1, 0}, kCanvas);
  ASSERT_FALSE(odd);
  EXPECT_NE(odd.error().message.find("; --width 2 gives 2 x 2"), std::string::npos)
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
