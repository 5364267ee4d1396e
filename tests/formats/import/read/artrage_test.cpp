#include "core/optics/srgb.h"
#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

std::string utf16(const std::string& text) {
  std::string out = "\xFF\xFE";
  for (const char c : text) {
    if (c == '\n') out += std::string("\r\0", 2);
    out += c;
    out += '\0';
  }
  return out;
}

const std::string kHead =
    "// ArtRage Script File\n<Version>\nScript Version: 1\n</Version>\n<Header>\n"
    "Painting Width: 1000\nPainting Height: 500\nPainting DPI: 72\n</Header>\n<Events>\n";
const std::string kStroke =
    "<StrokeEvent>\n<StrokeHeader>\n<EventPt>\tWait: 0.500s\tLoc: (100.5, 20)\tPr: 0.25\tTi: 1\t"
    "Ro: 0\tFw: 1\tBt: 1\tRv: NO\tIv: NO\n<Smooth>\tNO\n"
    "<PrevA>\tWait: 0.000s\tLoc: (9, 9)\tPr: 0\n<OldHd>\nWait: 7.000s\tLoc: (8, 8)\tPr: 0\n"
    "</OldHd>\n</StrokeHeader>\nWait: 0.010s\tLoc: (110, 30)\tPr: 1\tTi: 0.5\tRo: 0\tIv: NO\n"
    "</StrokeEvent>\n";

std::string command(const std::string& id, const std::string& value = "") {
  return "Wait: 1.000s\tEvType: Command\tCommandID: " + id + "\tValue: " + value + "\n";
}
Result<Sketch> read(const std::string& events) {
  const std::string bytes = utf16(kHead + events);
  return read_artrage({"a.arscript", bytes}, {});
}

TEST(ArtRage, ReadsAStroke) {
  const Result<Sketch> sketch = read(kStroke);
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 1u);
  const auto& stroke = std::get<Stroke>(sketch->items[0]);
  ASSERT_EQ(stroke.samples.size(), 2u);
  EXPECT_EQ(stroke.samples[0].x, 100.5);
  EXPECT_EQ(stroke.samples[0].y, 20);
  EXPECT_EQ(stroke.samples[0].pressure, 0.25f);
  EXPECT_NEAR(stroke.samples[0].tilt_x_deg, 0, 1e-4);
  EXPECT_NEAR(stroke.samples[1].tilt_x_deg, 45, 1e-4);
  EXPECT_NEAR(stroke.samples[1].time_s, 0.51, 1e-9);
  EXPECT_TRUE(stroke.timed && stroke.has_pressure && stroke.has_tilt && !stroke.erases);
  ASSERT_TRUE(sketch->page);
  EXPECT_EQ(sketch->page->width, 1000);
  EXPECT_EQ(sketch->page->height, 500);
}

TEST(ArtRage, FollowsCommands) {
  const Result<Sketch> sketch =
      read(command("CID_SetClearCanvas") + command("SetForeColour", "{ 0x080FF0000 }") +
           command("SetToolProperty", "{ 0x0B2D05E64 (Size), 1.5 }") +
           command("SetToolProperty", "{ 0x0B2D05E65 (Insta-Dry), 1 }") + kStroke +
           command("ToolPreset", "4906 (Eraser)") +
           command("SetToolProperty", "{ 0x0B2D05E65 (Insta-Dry), 0 }") + kStroke +
           command("Undo") + command("CID_SelectSpecificLayer", "3"));
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 5u);
  EXPECT_EQ(std::get<SketchAction>(sketch->items[0]), SketchAction::kClear);
  const auto& stroke = std::get<Stroke>(sketch->items[1]);
  EXPECT_EQ(stroke.color, (log::Rgb{1, 0, 0}));
  EXPECT_NEAR(stroke.opacity, 128 / 255.0, 1e-9);
  EXPECT_NEAR(stroke.width, 15, 1e-9);  // 1.5 % of 1000
  EXPECT_EQ(stroke.brush, BrushKind::kBristle);
  EXPECT_NEAR(stroke.samples[0].time_s, 4.5, 1e-9);
  EXPECT_EQ(std::get<SketchAction>(sketch->items[2]), SketchAction::kDry);
  EXPECT_TRUE(std::get<Stroke>(sketch->items[3]).erases);
  EXPECT_EQ(std::get<SketchAction>(sketch->items[4]), SketchAction::kUndo);
  EXPECT_EQ(sketch->report.dropped, (std::vector<std::string>{"1 commands for layers"}));
}

TEST(ArtRage, SkipsBlocksOfPictures) {
  const Result<Sketch> sketch = read("{\n\x01\x02 Wait: x Loc: (\n}\n" + kStroke);
  ASSERT_TRUE(sketch) << sketch.error().message;
  EXPECT_EQ(sketch->items.size(), 1u);
}

TEST(ArtRage, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> bad[] = {
      {"<StrokeEvent>\nLoc: 1, 2\n", "a.arscript:12: Loc is not (x, y)"},
      {"<StrokeEvent>\nLoc: (1, nan)\n", "a.arscript:12: Loc is no place within +-10000000"},
      {"<StrokeEvent>\nLoc: (1, 1e9)\n", "a.arscript:12: Loc is no place within +-10000000"},
      {"<StrokeEvent>\nLoc: (1, 2) Pr: 1.5\n", "a.arscript:12: pressure 1.5 is outside 0..1"},
      {"Wait: -1s EvType: x\n", "a.arscript:11: Wait -1 s is negative"},
      {"Wait: 1e300s EvType: x\n", "a.arscript:11: Wait is no number within +-1000000000"},
      {command("SetForeColour", "red"), "a.arscript:11: the colour is not 0x0AARRGGBB"},
      {"Painting Width: -3\n", "a.arscript:11: Painting Width is outside 1..10000000"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    EXPECT_EQ(sketch.error().message, message);
  }
}

TEST(ArtRage, IsToldByMarkAndTitle) {
  EXPECT_EQ(format_of(utf16(kHead)), find_format("artrage"));
  EXPECT_FALSE(is_artrage(kHead));
  EXPECT_FALSE(is_artrage(utf16("some text")));
  EXPECT_FALSE(is_artrage(""));
  EXPECT_FALSE(is_artrage("\xFF"));
}

TEST(ArtRage, NoDamageDoesHarm) {
  expect_no_harm_by_damage(
      "artrage", utf16(kHead + command("SetForeColour", "{ 0x0FFFF0000 }") + kStroke), 2000);
}

}  // namespace
}  // namespace pentimento::sketch
