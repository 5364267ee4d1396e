#include "formats/import/sketch/sketch_frame.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

Sketch line(double x0, double y0, double x1, double y1, double width = 0) {
  Sketch sketch;
  Stroke stroke;
  stroke.samples = {{.x = x0, .y = y0}, {.x = x1, .y = y1}};
  stroke.width = width;
  sketch.items.push_back(stroke);
  return sketch;
}

TEST(SketchFrame, APageIsTheCanvasItsLongerSideAMetre) {
  Sketch sketch = line(0, 0, 1, 1);
  sketch.page = Page{-100, 50, 600, 800};
  const auto frame = frame_of(sketch, 400);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->x0, -100);
  EXPECT_EQ(frame->y0, 50);
  EXPECT_DOUBLE_EQ(frame->canvas_width_m, 0.75);
  EXPECT_DOUBLE_EQ(frame->canvas_height_m, 1);
  EXPECT_EQ(frame->grid_width, 300);
  EXPECT_EQ(frame->grid_height, 400);
}

TEST(SketchFrame, WithoutAPageTheStrokesHaveAMargin) {
  const auto frame = frame_of(line(0, 0, 90, 40, 10), 1000);
  ASSERT_TRUE(frame);
  // Bounds with the width of the line 100 x 50, and 4 on each side.
  EXPECT_DOUBLE_EQ(frame->x0, -9);
  EXPECT_DOUBLE_EQ(frame->y0, -9);
  EXPECT_DOUBLE_EQ(frame->metre_per_unit, 1.0 / 108);
  EXPECT_DOUBLE_EQ(frame->canvas_height_m, 58.0 / 108);
}

TEST(SketchFrame, ALineGetsAStripAndAPointAndNothingACanvas) {
  const auto strip = frame_of(line(0, 5, 92, 5), 1600);
  ASSERT_TRUE(strip);
  EXPECT_GE(strip->grid_height, 100);
  for (const Sketch& sketch : {line(3, 3, 3, 3), Sketch{}}) {
    const auto frame = frame_of(sketch, 64);
    ASSERT_TRUE(frame);
    EXPECT_GT(frame->canvas_width_m, 0);
    EXPECT_GT(frame->grid_height, 0);
  }
}

TEST(SketchFrame, AUnitIsKeptAndACanvasThatCannotBeIsRefused) {
  Sketch sketch = line(0, 0, 2, 1);
  sketch.metre_per_unit = 1;
  const auto frame = frame_of(sketch, 100);
  ASSERT_TRUE(frame);
  EXPECT_DOUBLE_EQ(frame->canvas_width_m, 2.16);
  sketch.metre_per_unit = 1000;
  const auto huge = frame_of(sketch, 100);
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace pentimento::sketch
