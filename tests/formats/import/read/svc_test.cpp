#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read(std::string_view text) {
  return read_svc({"a.svc", text}, {});
}
const Stroke& stroke(const Result<Sketch>& sketch, std::size_t i) {
  return std::get<Stroke>(sketch->items.at(i));
}

// The counts and ranges of their SOURCE.txt.
TEST(Svc, ReadsARecordingInTheTabletsUnits) {
  const std::string bytes = recording("handwriting/device-units.svc");
  ASSERT_EQ(format_of(bytes), find_format("svc"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  EXPECT_EQ(counts_of(*sketch).strokes, 3);
  EXPECT_EQ(counts_of(*sketch).samples, 501);
  float most = 0;
  for (const Item& item : sketch->items)
    for (const Sample& s : std::get<Stroke>(item).samples) most = std::max(most, s.pressure);
  EXPECT_NEAR(most, 22634.0f / 32767, 1e-6f);
  // Milliseconds, and y upwards.
  EXPECT_NEAR(stroke(sketch, 0).samples[1].time_s - stroke(sketch, 0).samples[0].time_s, 0.008,
              1e-9);
  EXPECT_EQ(stroke(sketch, 0).samples[0].y, -7509);
}

TEST(Svc, ReadsARecordingInMillimetres) {
  const std::string bytes = recording("handwriting/physical-units.svc");
  ASSERT_EQ(format_of(bytes), find_format("svc"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  EXPECT_EQ(counts_of(*sketch).strokes, 5);
  EXPECT_EQ(counts_of(*sketch).samples, 819);
  EXPECT_NEAR(stroke(sketch, 0).samples[1].time_s, 0.007, 1e-9);
}

TEST(Svc, AzimuthsCountFromTheTopAndAltitudesFromTheTablet) {
  // Leaning by 45 degrees to the top, right, bottom and left.
  const Result<Sketch> sketch = read(
      "4\n0 0 0 1 0 450 1\n0 0 1 1 900 450 1\n0 0 2 1 1800 450 1\n"
      "0 0 3 1 2700 450 1\n0 0 4 1 0 900 1\n");
  ASSERT_TRUE(sketch) << sketch.error().message;
  const std::vector<Sample>& samples = stroke(sketch, 0).samples;
  const float expected[5][2] = {{0, -45}, {45, 0}, {0, 45}, {-45, 0}, {0, 0}};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_NEAR(samples[i].tilt_x_deg, expected[i][0], 1e-4f) << i;
    EXPECT_NEAR(samples[i].tilt_y_deg, expected[i][1], 1e-4f) << i;
  }
}

TEST(Svc, SaysWhatIsWrongAndWhere) {
  const std::pair<const char*, const char*> bad[] = {
      {"1\n0 0 0 1 0 900\n", "a.svc:2: 6 columns, a row has 7"},
      {"1\n0 0 0 1 0 900 nan\n", "a.svc:2: 'nan' is not a number"},
      {"1\n0 0 0 1 0 900 40000\n", "a.svc:2: pressure 40000 is outside 0..32767"},
      {"1\n0 0 0 1 0 900 1.5\n", "a.svc:2: pressure 1.5 is outside 0..1"},
      {"2\n0 0 5 1 0 900 1\n0 0 4 1 0 900 1\n", "a.svc:3: time 4 runs back"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
}

TEST(Svc, NoDamageDoesHarm) {
  expect_no_harm_by_damage("svc", recording("handwriting/device-units.svc"), 200);
}

}  // namespace
}  // namespace pentimento::sketch
