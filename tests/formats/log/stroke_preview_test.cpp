#include "formats/log/stroke_preview.h"

#include <gtest/gtest.h>

#include "tests/formats/log/edit/edited.h"

namespace pentimento::log {
namespace {

using enum TouchPhase;
constexpr Rgb kRed = {1, 0, 0};

Header square() {
  Header header;
  header.canvas_width_m = header.canvas_height_m = 1;
  return header;
}
Event place(TouchPhase phase, double x_m, double y_m) {
  Event event = touch(0, phase, x_m);
  std::get<Touch>(event.action).y_m = y_m;
  return event;
}
Event red() {
  Color color;
  color.value = kRed;
  return at(0, color);
}

TEST(StrokePreview, DrawsStrokesInTheirColoursWhereTheyAre) {
  StrokePreview preview(square(), 10);
  ASSERT_EQ(preview.width(), 10);
  ASSERT_EQ(preview.height(), 10);
  for (const Event& event : {red(), at(0, Slider{"size", 0.1}), place(kDown, 0.15, 0.25),
                             place(kMove, 0.85, 0.25), place(kUp, 0.85, 0.25)})
    preview.add(event);
  for (int x = 0; x < 10; ++x) {
    EXPECT_EQ(preview.at(x, 2), x >= 1 && x <= 8 ? std::optional(kRed) : std::nullopt) << x;
    EXPECT_FALSE(preview.at(x, 4)) << x;
  }
  // A wide brush covers rows beside it; a clear takes all away.
  for (const Event& event :
       {at(0, Slider{"size", 0.5}), place(kDown, 0.5, 0.7), place(kUp, 0.5, 0.7)})
    preview.add(event);
  EXPECT_TRUE(preview.at(5, 5) && preview.at(5, 8));
  preview.add(at(0, Clear{}));
  EXPECT_FALSE(preview.at(5, 5));
}

TEST(StrokePreview, KnowsTheHeadersPigments) {
  StrokePreview preview(square(), 4);
  preview.set_pigment("madder", kRed);
  Color color;
  color.pigment = "madder";
  for (const Event& event : {at(0, color), place(kDown, 0.1, 0.1)}) preview.add(event);
  EXPECT_EQ(preview.at(0, 0), kRed);
}

TEST(StrokePreview, TheRagWipes) {
  StrokePreview preview(square(), 4);
  for (const Event& event : {red(), place(kDown, 0.1, 0.1), place(kUp, 0.1, 0.1)})
    preview.add(event);
  ASSERT_TRUE(preview.at(0, 0));
  for (const Event& event :
       {at(0, BrushChange{"rag"}), place(kDown, 0.1, 0.1), place(kUp, 0.1, 0.1)})
    preview.add(event);
  EXPECT_FALSE(preview.at(0, 0));
}

TEST(StrokePreview, IsHalfBlocksRowByRow) {
  StrokePreview preview(square(), 2);
  for (const Event& event : {red(), at(0, Slider{"size", 0.1}), place(kDown, 0.25, 0.75)})
    preview.add(event);
  const std::string bare = "\x1b[38;2;235;232;225m\x1b[48;2;235;232;225m\u2580";
  EXPECT_EQ(preview.text(), "\x1b[38;2;235;232;225m\x1b[48;2;255;0;0m\u2580" + bare + "\x1b[0m\n");
}

TEST(StrokePreview, StaysSmallAndOnTheCanvasWhateverTheLog) {
  Header tower = square();
  tower.canvas_height_m = 100;
  tower.canvas_width_m = 0.001;
  StrokePreview preview(tower, 64);
  EXPECT_EQ(preview.width(), 1);
  StrokePreview wide(square(), 8);
  for (const Event& event : {at(0, Slider{"size", 100}), place(kMove, 0, 0),
                             place(kDown, -900, 900), place(kMove, 900, -900), place(kUp, 1e3, 0)})
    wide.add(event);
  EXPECT_TRUE(wide.at(4, 4));
}

}  // namespace
}  // namespace pentimento::log
