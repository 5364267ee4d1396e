#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read(std::string_view text) {
  return read_pointer_json({"a.json", text}, {});
}
const Stroke& stroke(const Result<Sketch>& sketch, std::size_t i) {
  return std::get<Stroke>(sketch->items.at(i));
}

TEST(PointerJson, ReadsARealRecording) {
  const std::string bytes = recording("handwriting/pointer-events.json");
  ASSERT_EQ(format_of(bytes), find_format("pointer-json"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  // Its SOURCE.txt: 1 stroke, 148 events down, pressure up to 0.608, tiltX up to 51.
  EXPECT_EQ(counts_of(*sketch).strokes, 1);
  EXPECT_EQ(counts_of(*sketch).samples, 148);
  float most = 0, lean = 0;
  for (const Sample& s : stroke(sketch, 0).samples) {
    most = std::max(most, s.pressure);
    lean = std::max(lean, s.tilt_x_deg);
  }
  EXPECT_NEAR(most, 0.608f, 5e-4f);
  EXPECT_LE(lean, 51);
}

TEST(PointerJson, ButtonsAreTheTipAndTheEraser) {
  const Result<Sketch> sketch =
      read(R"({"x":[1,2,3,4,5,6],"y":[1,1,1,1,1,1],"time":[0,10,20,30,40,50],)"
           R"("buttons":[0,1,1,0,32,32],"pressure":[0,0.2,0.4,0,0.3,0.3]})");
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 2u);
  EXPECT_EQ(stroke(sketch, 0).samples.size(), 2u);
  EXPECT_FALSE(stroke(sketch, 0).erases);
  EXPECT_TRUE(stroke(sketch, 1).erases);
  EXPECT_DOUBLE_EQ(stroke(sketch, 1).samples[1].time_s, 0.05);
}

TEST(PointerJson, AMouseHasNoPressureAndRepeatedEventsAreOne) {
  const Result<Sketch> sketch =
      read(R"({"x":[1,1,2],"y":[1,1,1],"time":[0,0,20],"pressure":[0.5,0.5,0.5]})");
  ASSERT_TRUE(sketch) << sketch.error().message;
  EXPECT_FALSE(stroke(sketch, 0).has_pressure);
  EXPECT_EQ(stroke(sketch, 0).samples.size(), 2u);
  EXPECT_EQ(sketch->report.dropped, (std::vector<std::string>{"1 repeated events"}));
}

TEST(PointerJson, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> bad[] = {
      {R"({"x":[1],"time":[1],"tiltX":[1]})", "a.json: y is missing, or no array"},
      {R"({"x":[1],"y":[1,2],"time":[1]})", "a.json: y has 2 values, x has 1"},
      {R"({"x":[1],"y":["a"],"time":[1]})", "a.json: y[0] is not a number of -10000000..10000000"},
      {R"({"x":[1],"y":[1],"time":[1],"pressure":[2]})",
       "a.json: pressure[0] is not a number of 0..1"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
  EXPECT_TRUE(read("{\"x\":[1").error().message.starts_with("a.json: not valid JSON"));
}

TEST(PointerJson, NoDamageDoesHarm) {
  expect_no_harm_by_damage("pointer-json", recording("handwriting/pointer-events.json"), 200);
}

}  // namespace
}  // namespace pentimento::sketch
