#include "formats/import/sketch/sketch_log.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "formats/log/write/to_json.h"

namespace pentimento::sketch {
namespace {

class Lines : public log::Writer {
 public:
  void write(const log::Header& header) override { head = header; }
  void write(const log::Event& event) override { lines.push_back(log::event_json(event)); }
  Result<Published> finish() override { return Published{}; }
  log::Header head;
  std::vector<std::string> lines;
};

/// A unit square's side on a page of 10 x 10.
Stroke line(double x, double begin_s, double end_s) {
  Stroke stroke;
  stroke.timed = true;
  stroke.samples = {{.x = x, .y = 1, .time_s = begin_s}, {.x = x, .y = 2, .time_s = end_s}};
  stroke.width = 0.5;
  stroke.color = {1, 1, 1};
  return stroke;
}
Sketch on_page(std::vector<Item> items) {
  Sketch sketch;
  sketch.items = std::move(items);
  sketch.page = Page{0, 0, 10, 10};
  return sketch;
}

TEST(SketchLog, WritesBrushSizeAndColourOnceAndThenTheSamples) {
  Lines out;
  Sketch sketch = on_page({line(1, 5, 6), line(2, 7, 8)});
  sketch.title = "T";
  const auto counts = write_log(sketch, {"mypaint", "a.dat", "beef"}, {}, out);
  ASSERT_TRUE(counts);
  EXPECT_EQ(counts->strokes, 2);
  EXPECT_EQ(counts->samples, 4);
  EXPECT_EQ(out.head.title, "T");
  EXPECT_EQ(out.head.extensions,
            R"("x-source":{"format":"mypaint","file":"a.dat","sha256":"beef"})");
  const std::vector<std::string> expected = {
      R"({"t":0,"type":"brush","name":"pen"})",
      R"({"t":0,"type":"slider","name":"size","value":0.05})",
      R"({"t":0,"type":"color","value":"#ffffff"})",
      R"({"t":0,"type":"touch","phase":"down","x":0.1,"y":0.1})",
      R"({"t":1,"type":"touch","phase":"move","x":0.1,"y":0.2})",
      R"({"t":1,"type":"touch","phase":"up","x":0.1,"y":0.2})",
      R"({"t":2,"type":"touch","phase":"down","x":0.2,"y":0.1})",
      R"({"t":3,"type":"touch","phase":"move","x":0.2,"y":0.2})",
      R"({"t":3,"type":"touch","phase":"up","x":0.2,"y":0.2})"};
  EXPECT_EQ(out.lines, expected);
}

TEST(SketchLog, BringsTheBrushesThatItUsesAndNoOthers) {
  Lines out;
  Stroke pen = line(1, 0, 1), soft = line(2, 2, 3), flat = line(3, 4, 5), bristle = line(4, 6, 7);
  soft.width_share_unpressed = 0.2;
  flat.brush = BrushKind::kFlat;
  flat.width_share_unpressed = 1;
  bristle.brush = BrushKind::kBristle;
  ASSERT_TRUE(write_log(on_page({pen, soft, flat, bristle}), {}, {}, out));
  ASSERT_EQ(out.head.brushes.size(), 3u) << "bristle is built in";
  EXPECT_EQ(out.head.brushes[0].name, "flat 1");
  EXPECT_EQ(out.head.brushes[0].shape, "flat");
  EXPECT_EQ(out.head.brushes[0].size_pressure, 0);
  EXPECT_FALSE(out.head.brushes[0].capacity) << "paint runs dry";
  EXPECT_EQ(out.head.brushes[1].name, "pen");
  EXPECT_FALSE(out.head.brushes[1].size_pressure);
  EXPECT_EQ(out.head.brushes[2].name, "pen 0.2");
  EXPECT_EQ(out.head.brushes[2].size_pressure, 0.8);
  EXPECT_TRUE(out.head.brushes[2].capacity);
  const auto uses = [&](const std::string& name) {
    const std::string wanted = "\"name\":\"" + name + "\"";
    return std::any_of(out.lines.begin(), out.lines.end(), [&](const std::string& line) {
      return line.find(wanted) != std::string::npos;
    });
  };
  for (const char* name : {"pen", "pen 0.2", "flat 1", "bristle"}) EXPECT_TRUE(uses(name)) << name;
}

TEST(SketchLog, StrokesThatOverlapHaveIdsOfTheirOwn) {
  Lines out;
  ASSERT_TRUE(write_log(on_page({line(1, 0, 4), line(2, 1, 2), line(3, 3, 5)}), {}, {}, out));
  std::vector<std::string> ids;
  for (const std::string& l : out.lines)
    if (l.find("\"down\"") != std::string::npos)
      ids.push_back(l.find("\"id\":1") != std::string::npos ? "1" : "0");
  EXPECT_EQ(ids, (std::vector<std::string>{"0", "1", "1"}));
}

TEST(SketchLog, RefusesMoreTouchesAtOnceThanALogMayHave) {
  std::vector<Item> items;
  for (int i = 0; i < 65; ++i) items.push_back(line(1, 0.001 * i, 9));
  Lines out;
  const auto counts = write_log(on_page(items), {}, {}, out);
  ASSERT_FALSE(counts);
  EXPECT_EQ(counts.error().code, ErrorCode::kLimit);
}

TEST(SketchLog, AnEraserIsARagAndThinPaintHasLessPigment) {
  Stroke glaze = line(1, 0, 1), eraser = line(2, 2, 3);
  glaze.opacity = 0.5;
  glaze.brush = BrushKind::kFlat;
  eraser.erases = true;
  Lines out;
  ASSERT_TRUE(
      write_log(on_page({glaze, SketchAction::kUndo, eraser, SketchAction::kClear}), {}, {}, out));
  EXPECT_EQ(out.lines[0], R"({"t":0,"type":"brush","name":"flat"})");
  EXPECT_EQ(out.lines[3], R"({"t":0,"type":"slider","name":"pigment","value":0.35})");
  EXPECT_EQ(out.lines[7], R"({"t":1,"type":"undo"})");
  EXPECT_EQ(out.lines[8], R"({"t":2,"type":"brush","name":"rag"})");
  EXPECT_EQ(out.lines.back(), R"({"t":3,"type":"clear"})");
}

TEST(SketchLog, WithoutAnyStrokeItIsAnEmptyCanvas) {
  Lines out;
  const auto counts = write_log({}, {}, {}, out);
  ASSERT_TRUE(counts);
  EXPECT_TRUE(out.lines.empty());
  EXPECT_DOUBLE_EQ(counts->canvas_height_m, 0.75);
}

}  // namespace
}  // namespace pentimento::sketch
