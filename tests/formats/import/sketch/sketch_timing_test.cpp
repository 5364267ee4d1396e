#include "formats/import/sketch/sketch_timing.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

Stroke timed(double begin_s, double end_s, double width = 1) {
  Stroke stroke;
  stroke.timed = true;
  stroke.width = width;
  stroke.samples = {{.time_s = begin_s}, {.x = 1, .time_s = end_s}};
  return stroke;
}

std::vector<double> beginnings(std::vector<Item> items) {
  Sketch sketch;
  sketch.items = std::move(items);
  std::vector<double> out;
  for (const TimedItem& item : time_items(sketch, {10, 2}).items) out.push_back(item.begin_s);
  return out;
}

TEST(SketchTiming, BeginsAtZeroAndKeepsTheTimesBetween) {
  EXPECT_EQ(beginnings({timed(100, 101), timed(103, 104), timed(104, 105)}),
            (std::vector<double>{0, 3, 4}));
}

TEST(SketchTiming, CutsLongPauses) {
  EXPECT_EQ(beginnings({timed(0, 1), timed(8e7, 8e7 + 1), timed(8e7 + 2, 8e7 + 3)}),
            (std::vector<double>{0, 11, 13}));
}

TEST(SketchTiming, OrdersStrokesByTheirTimesBetweenActions) {
  EXPECT_EQ(beginnings({timed(5, 6), timed(2, 3), SketchAction::kDry, timed(1, 2)}),
            (std::vector<double>{0, 3, 4, 4}));
}

TEST(SketchTiming, StrokesAtOnceMustLookAlike) {
  EXPECT_EQ(beginnings({timed(0, 4), timed(1, 3)}), (std::vector<double>{0, 1}));
  EXPECT_EQ(beginnings({timed(0, 4), timed(1, 3, 2)}), (std::vector<double>{0, 4}));
}

TEST(SketchTiming, TellsWhatItChanged) {
  Sketch sketch;
  sketch.items = {timed(0, 4), timed(1, 3, 2), timed(60, 61)};
  const Timetable found = time_items(sketch, {10, 2});
  EXPECT_EQ(found.waiting, 1);
  EXPECT_DOUBLE_EQ(found.items[2].begin_s, 16);
  EXPECT_DOUBLE_EQ(found.cut_s, 47) << "the second stroke was moved by 3 s, the third comes at 63";
  EXPECT_EQ(time_items(Sketch(), {10, 2}).cut_s, 0);
}

TEST(SketchTiming, StrokesWithoutTimesFollowOneAnother) {
  Stroke stroke;
  stroke.samples = {{.x = 0}, {.x = 3}, {.x = 3, .y = 1}};
  const std::vector<double> found = beginnings({stroke, stroke, timed(50, 51)});
  EXPECT_DOUBLE_EQ(found[0], 0);
  EXPECT_DOUBLE_EQ(found[1], 2.2);   // 4 units at 2 a second, and a lift of the hand
  EXPECT_DOUBLE_EQ(found[2], 14.2);  // ten seconds later at most
}

}  // namespace
}  // namespace pentimento::sketch
