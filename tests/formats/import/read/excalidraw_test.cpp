#include "core/optics/srgb.h"
#include "formats/import/read/css_color.h"
#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read(std::string_view text) {
  return read_excalidraw({"a.excalidraw", text}, {});
}

/// A scene of one stroke with more members.
std::string scene(const std::string& members) {
  return R"({"type":"excalidraw","elements":[{"type":"freedraw",)" + members + "}]}";
}

float most_pressure(const Sketch& sketch) {
  float most = 0;
  for (const Item& item : sketch.items)
    for (const Sample& s : std::get<Stroke>(item).samples) most = std::max(most, s.pressure);
  return most;
}

TEST(Excalidraw, ReadsARealLibrary) {
  const std::string bytes = recording("excalidraw/despair.excalidrawlib");
  ASSERT_EQ(format_of(bytes), find_format("excalidraw"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  // Its SOURCE.txt: 137 strokes of 2142 points, 95 other elements, pressures to 0.529, width 1.
  EXPECT_EQ(counts_of(*sketch).strokes, 137);
  EXPECT_EQ(counts_of(*sketch).samples, 2142);
  EXPECT_NEAR(most_pressure(*sketch), 0.529f, 5e-4f);
  EXPECT_EQ(std::get<Stroke>(sketch->items[0]).width, 4.25);
  ASSERT_EQ(sketch->report.dropped.size(), 1u);
  EXPECT_EQ(sketch->report.dropped[0], "95 elements that are no free-hand strokes");
}

TEST(Excalidraw, ReadsARealScene) {
  const std::string bytes = recording("excalidraw/panels.excalidraw");
  ASSERT_EQ(format_of(bytes), find_format("excalidraw"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  // Its SOURCE.txt: 8 strokes of 21 points, pressures to 0.08, 10 other elements.
  EXPECT_EQ(counts_of(*sketch).strokes, 8);
  EXPECT_EQ(counts_of(*sketch).samples, 21);
  EXPECT_NEAR(most_pressure(*sketch), 0.08f, 1e-6f);
  EXPECT_EQ(sketch->report.dropped[0], "10 elements that are no free-hand strokes");
  EXPECT_EQ(sketch->paper, (log::Rgb{1, 1, 1}));
}

TEST(Excalidraw, ReadsBareRows) {
  const std::string bytes = recording("excalidraw/points-x-y-pressure-ms.json");
  ASSERT_EQ(format_of(bytes), find_format("excalidraw"));
  const Result<Sketch> sketch = read(bytes);
  ASSERT_TRUE(sketch) << sketch.error().message;
  expect_sound(*sketch);
  // Its SOURCE.txt: 360 rows, pressure always 0.5, 3.277 s.
  ASSERT_EQ(sketch->items.size(), 1u);
  const auto& stroke = std::get<Stroke>(sketch->items[0]);
  EXPECT_EQ(stroke.samples.size(), 360u);
  EXPECT_TRUE(stroke.timed && !stroke.has_pressure);
  EXPECT_NEAR(stroke.samples.back().time_s, 3.277, 1e-9);
  EXPECT_EQ(stroke.samples[1].time_s, 0);
  EXPECT_EQ(stroke.samples[0].x, 23.96);
}

TEST(Excalidraw, TurnsClockwiseAboutTheCentreOfTheBox) {
  const Result<Sketch> sketch =
      read(scene(R"("x":10,"y":20,"points":[[0,0],[8,0],[8,4]],"angle":1.5707963267948966)"));
  ASSERT_TRUE(sketch) << sketch.error().message;
  const auto& samples = std::get<Stroke>(sketch->items[0]).samples;
  // The centre is (14, 22): (-4, -2) from it becomes (2, -4), and (4, 2) becomes (-2, 4).
  EXPECT_NEAR(samples[0].x, 16, 1e-9);
  EXPECT_NEAR(samples[0].y, 18, 1e-9);
  EXPECT_NEAR(samples[2].x, 12, 1e-9);
  EXPECT_NEAR(samples[2].y, 26, 1e-9);
}

TEST(Excalidraw, KeepsColourOpacityAndWidth) {
  const Result<Sketch> sketch = read(scene(
      R"("x":0,"y":0,"points":[[0,0],[1,1]],"strokeColor":"#f008","opacity":50,"strokeWidth":2)"));
  ASSERT_TRUE(sketch) << sketch.error().message;
  const auto& stroke = std::get<Stroke>(sketch->items[0]);
  EXPECT_EQ(stroke.color, (log::Rgb{1, 0, 0}));
  EXPECT_NEAR(stroke.opacity, 0.5 * 0x88 / 255.0, 1e-12);
  EXPECT_EQ(stroke.width, 8.5);
  EXPECT_FALSE(stroke.has_pressure || stroke.timed);
}

TEST(Excalidraw, LeavesOutDeletedAndTransparentStrokes) {
  const Result<Sketch> sketch = read(
      R"({"type":"excalidraw","elements":[{"type":"freedraw","points":[[0,0]],"isDeleted":true},
      {"type":"freedraw","points":[[0,0]],"strokeColor":"transparent"},
      {"type":"freedraw","points":[[3,0]],"simulatePressure":true,"pressures":[0.2]}]})");
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 1u);
  EXPECT_EQ(std::get<Stroke>(sketch->items[0]).samples[0].x, 3);
  EXPECT_FALSE(std::get<Stroke>(sketch->items[0]).has_pressure);
  EXPECT_EQ(sketch->report.dropped,
            (std::vector<std::string>{"1 deleted elements", "1 transparent strokes"}));
}

TEST(Excalidraw, LaysTheItemsOfALibraryBesideOneAnother) {
  const std::string item = R"({"elements":[{"type":"freedraw","x":5,"y":-7,
      "points":[[0,0],[100,100]]}]})";
  const Result<Sketch> sketch =
      read(R"({"type":"excalidrawlib","libraryItems":[)" + item + "," + item + "," + item + "]}");
  ASSERT_TRUE(sketch) << sketch.error().message;
  const auto first = [&](std::size_t i) { return std::get<Stroke>(sketch->items[i]).samples[0]; };
  // A row holds 1.2 sqrt(3 * 120^2) = 249 px: two items.
  EXPECT_NEAR(first(0).x, 0, 1e-9);
  EXPECT_NEAR(first(0).y, 0, 1e-9);
  EXPECT_NEAR(first(1).x, 120, 1e-9);
  EXPECT_NEAR(first(1).y, 0, 1e-9);
  EXPECT_NEAR(first(2).x, 0, 1e-9);
  EXPECT_NEAR(first(2).y, 120, 1e-9);
}

TEST(Excalidraw, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> bad[] = {
      {R"({"type":"excalidraw"})", "a.excalidraw: root: no array 'elements' or 'libraryItems'"},
      {scene(R"("x":1e300,"points":[])"),
       "a.excalidraw: element 1: x 1e+300 is outside -1000000000..1000000000"},
      {scene(R"("points":[[0]])"), "a.excalidraw: element 1: point 1 is not [x, y]"},
      {scene(R"("points":[[0,"1"]])"), "a.excalidraw: element 1: y of a point is not a number"},
      {scene(R"("points":[[0,0]],"pressures":[1.5])"),
       "a.excalidraw: element 1: pressure 1.5 is outside 0..1"},
      {scene(R"("points":[[0,0]],"pressures":[1,1])"),
       "a.excalidraw: element 1: 2 pressures for 1 points"},
      {"[[0,0,0.5,10],[0,0,0.5,9]]", "a.excalidraw: row 2: time 0.009 s runs back from 0.01 s"},
      {"[[0,0,0.5]]", "a.excalidraw: row 1: a row is [x, y, pressure, milliseconds]"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
  EXPECT_FALSE(read("[[0,0,NaN,0]]"));
  EXPECT_FALSE(read(std::string(100000, '[')));
}

TEST(Excalidraw, TakesNoOtherJson) {
  EXPECT_TRUE(is_excalidraw(" [ [1, 2, 0.5, 3e1 ], [] ]"));
  EXPECT_TRUE(is_excalidraw(R"({"a":1,"type" : "excalidraw"})"));
  for (const char* other : {"", "[", "[[", "[[]]", "[[1,2,3]]", "[[1,2,3,{}]]", "{}", "{\"type\"",
                            R"({"type":"excalidraws"})", R"({"x":[1],"tiltX":[0]})"})
    EXPECT_FALSE(is_excalidraw(other)) << other;
}

TEST(Excalidraw, NoDamageDoesHarm) {
  expect_no_harm_by_damage("excalidraw", recording("excalidraw/panels.excalidraw"), 300);
  expect_no_harm_by_damage(
      "excalidraw",
      recording("excalidraw/points-x-y-pressure-ms.json").substr(0, 600) + "1,1,0.5,900]]", 100);
}

TEST(CssColor, KnowsHexadecimalAndNames) {
  EXPECT_EQ(css_color("#222")->linear, css_color("#222222")->linear);
  EXPECT_EQ(css_color("#FF0000")->linear, css_color("Red")->linear);
  EXPECT_NEAR(css_color("#808080")->linear[1], 0.21586, 1e-5);  // not 0.5: linear light
  EXPECT_NEAR(css_color("#00000080")->opacity, 128 / 255.0, 1e-12);
  EXPECT_EQ(css_color("transparent")->opacity, 0);
  for (const char* other : {"", "#", "#12", "#12345", "#gggggg", "var(--x)", "rgb(0,0,0)"})
    EXPECT_FALSE(css_color(other)) << other;
}

}  // namespace
}  // namespace pentimento::sketch
