#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

const std::string kFile = "mypaint-painting30sec/painting30sec.dat";

Result<Sketch> read(std::string_view text) {
  return read_mypaint({"a.dat", text}, {});
}

TEST(MyPaint, ReadsARealRecording) {
  const std::string bytes = recording(kFile);
  ASSERT_EQ(format_of(bytes), find_format("mypaint"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  // Its SOURCE.txt: 30 strokes, 2253 samples with the pen down, pressure up to 0.546.
  EXPECT_EQ(counts_of(*sketch).strokes, 30);
  EXPECT_EQ(counts_of(*sketch).samples, 2253);
  float most = 0;
  double left = 1e9, right = 0, top = 1e9, bottom = 0;
  for (const Item& item : sketch->items) {
    for (const Sample& s : std::get<Stroke>(item).samples) {
      most = std::max(most, s.pressure);
      left = std::min(left, s.x);
      right = std::max(right, s.x);
      top = std::min(top, s.y);
      bottom = std::max(bottom, s.y);
    }
  }
  EXPECT_NEAR(most, 0.546f, 5e-4f);
  EXPECT_NEAR(left, 175.7, 0.05);
  EXPECT_NEAR(right, 795.1, 0.05);
  EXPECT_NEAR(top, 57.1, 0.05);
  EXPECT_NEAR(bottom, 602.7, 0.05);  // 604.4 with the pen in the air
}

TEST(MyPaint, AHoverPartsStrokes) {
  const Result<Sketch> sketch = read("0 1 2 0.5\n1 2 2 0.25\r\n2 3 3 0\n3 4 4 1\n");
  ASSERT_TRUE(sketch);
  ASSERT_EQ(sketch->items.size(), 2u);
  const auto& first = std::get<Stroke>(sketch->items[0]);
  ASSERT_EQ(first.samples.size(), 2u);
  EXPECT_EQ(first.samples[1].pressure, 0.25f);
  EXPECT_EQ(first.samples[1].time_s, 1);
  EXPECT_TRUE(first.timed && first.has_pressure && !first.has_tilt);
}

TEST(MyPaint, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> bad[] = {
      {"0 1 2 0.5\n1 2 3\n", "a.dat:2: 3 columns, a row has 4"},
      {"0 1 2 0.5\n1 2 x 0.5\n", "a.dat:2: 'x' is not a number"},
      {"0 1 nan 0.5\n", "a.dat:1: 'nan' is not a number"},
      {"2 1 2 0.5\n1 1 2 0.5\n", "a.dat:2: time 1 runs back from 2"},
      {"0 1 2 1.5\n", "a.dat:1: pressure 1.5 is outside 0..1"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
}

TEST(MyPaint, NoDamageDoesHarm) {
  expect_no_harm_by_damage("mypaint", recording(kFile).substr(0, 20000), 200);
}

}  // namespace
}  // namespace pentimento::sketch
