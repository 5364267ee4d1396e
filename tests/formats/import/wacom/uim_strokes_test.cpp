#include "formats/import/wacom/uim_strokes.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

/// Three samples; `points` of the spline at 10, 11, 12, ..
UimInk ink(int points) {
  UimInk out;
  UimStroke stroke;
  for (int i = 0; i < points; ++i) {
    stroke.x.push_back(10 + i);
    stroke.y.push_back(50);
  }
  stroke.size = {1, 2, 3};
  stroke.sensor = "s";
  out.strokes.push_back(stroke);
  UimSensor& sensor = out.sensors["s"];
  sensor.time_s = {7, 9, 8};
  sensor.x_px = {100, 101, 104};
  sensor.y_px = {200, 200, 202};
  sensor.pressure = {0.1, 0.2, 0.3};
  return out;
}
Sketch drawn(const UimInk& from) {
  Sketch out;
  add_uim_strokes(from, out);
  return out;
}
const Stroke& first(const Sketch& sketch) {
  return std::get<Stroke>(sketch.items.at(0));
}

TEST(UimStrokes, SamplesLieOnTheSplinesPoints) {
  const Sketch sketch = drawn(ink(8));
  const Stroke& stroke = first(sketch);
  ASSERT_EQ(stroke.samples.size(), 3u);
  EXPECT_DOUBLE_EQ(stroke.samples[0].x, 13);
  EXPECT_DOUBLE_EQ(stroke.samples[2].x, 15);
  EXPECT_DOUBLE_EQ(stroke.samples[2].y, 50);
  EXPECT_DOUBLE_EQ(stroke.samples[2].time_s, 9) << "time does not run back";
  EXPECT_FLOAT_EQ(stroke.samples[2].pressure, 0.3f);
  EXPECT_TRUE(stroke.timed && stroke.has_pressure);
  EXPECT_FALSE(stroke.has_tilt);
  EXPECT_DOUBLE_EQ(stroke.width, 2);
}

TEST(UimStrokes, ElseThePathIsShiftedOntoTheSpline) {
  const Sketch sketch = drawn(ink(5));  // 10..14, middle 12; the sensor's is 102, 201
  const Stroke& stroke = first(sketch);
  EXPECT_DOUBLE_EQ(stroke.samples[0].x, 10);
  EXPECT_DOUBLE_EQ(stroke.samples[2].x, 14);
  EXPECT_DOUBLE_EQ(stroke.samples[0].y, 49);
  EXPECT_DOUBLE_EQ(stroke.samples[2].y, 51);
}

TEST(UimStrokes, WithoutASensorThereAreNoTimes) {
  UimInk bare = ink(4);
  bare.strokes[0].sensor = "gone";
  bare.strokes[0].x[1] = bare.strokes[0].x[0];  // the end is repeated
  const Sketch sketch = drawn(bare);
  EXPECT_FALSE(first(sketch).timed);
  EXPECT_EQ(first(sketch).samples.size(), 3u);
  const std::vector<std::string>& dropped = sketch.report.dropped;
  EXPECT_EQ(dropped.at(0), "1 recordings of erased strokes");
  // A sensor that measured nothing but the pressure does not help either.
  UimInk blind = ink(4);
  blind.sensors["s"].x_px.clear();
  EXPECT_FALSE(first(drawn(blind)).timed);
}

TEST(UimStrokes, HaveTheBrushThatWasRead) {
  UimInk various = ink(8);
  various.strokes[0].erases = true;
  various.strokes[0].brush = BrushKind::kFlat;
  various.empty_strokes = 3;
  const Sketch sketch = drawn(various);
  EXPECT_TRUE(first(sketch).erases);
  EXPECT_EQ(first(sketch).brush, BrushKind::kFlat);
  EXPECT_EQ(sketch.report.dropped.at(0), "3 strokes without points");
}

}  // namespace
}  // namespace pentimento::sketch
