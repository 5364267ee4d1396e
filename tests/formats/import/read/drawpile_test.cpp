#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

const std::string kHead = "!version=dp:4.25.1\n# a comment\n";

Result<Sketch> read(const std::string& lines) {
  return read_drawpile({"a.dptxt", kHead + lines}, {});
}

/// A line of two dabs from (x, 10) on.
std::string dabs(int user, int x, const std::string& mode = "svg:src-over",
                 const std::string& layer = "0x0101", const std::string& color = "#ff0000") {
  return std::to_string(user) + R"( classicdabs {"layer":")" + layer + R"(","x":)" +
         std::to_string(x) + R"(,"y":10,"color":")" + color + R"(","mode":")" + mode +
         R"(","_":[{"x":0,"y":0,"size":8,"hardness":255,"opacity":255},[2,1.25,4,255,102]]})" +
         "\n";
}

double x_of(const Result<Sketch>& sketch, std::size_t i) {
  if (!sketch || sketch->items.size() <= i) return NAN;
  return std::get<Stroke>(sketch->items[i]).samples[0].x;
}

TEST(Drawpile, JoinsDabsToStrokesByUser) {
  const Result<Sketch> sketch =
      read(dabs(1, 10) + dabs(2, 50) + dabs(1, 14) + "1 penup {}\n" + dabs(1, 20));
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 3u);
  const auto& first = std::get<Stroke>(sketch->items[0]);
  ASSERT_EQ(first.samples.size(), 4u);
  EXPECT_EQ(first.samples[1].x, 12);
  EXPECT_EQ(first.samples[1].y, 11.25);
  EXPECT_EQ(first.samples[1].pressure, 0.5f);
  EXPECT_EQ(first.samples[2].x, 14);
  EXPECT_EQ(first.width, 8);
  EXPECT_EQ(first.opacity, 1);
  EXPECT_EQ(first.color, (log::Rgb{1, 0, 0}));
  EXPECT_TRUE(first.has_pressure && !first.timed && !first.erases);
}

TEST(Drawpile, UndoesByUser) {
  const std::string painted = "1 undopoint {}\n" + dabs(1, 1) + "2 undopoint {}\n" + dabs(2, 2) +
                              "1 undopoint {}\n" + dabs(1, 3);
  const Result<Sketch> undone = read(painted + "1 undo {}\n1 undo {\"redo\":false}\n");
  EXPECT_EQ(undone->items.size(), 1u);
  EXPECT_EQ(x_of(undone, 0), 2);
  EXPECT_EQ(undone->report.dropped[0], "2 undone strokes");
  const Result<Sketch> redone = read(painted + "1 undo {}\n1 undo {}\n1 undo {\"redo\":true}\n");
  EXPECT_EQ(redone->items.size(), 2u);
  EXPECT_EQ(x_of(redone, 0), 1);
  const Result<Sketch> other = read(painted + "1 undo {\"override_user\":2}\n");
  EXPECT_EQ(other->items.size(), 2u);
  EXPECT_EQ(x_of(other, 1), 3);
}

TEST(Drawpile, FollowsTheCanvas) {
  const Result<Sketch> sketch =
      read(R"(1 resize {"top":0,"right":200,"bottom":100,"left":0})"
           "\n" +
           dabs(1, 10) + "1 penup\n" + R"(1 resize {"left":50,"top":5})" + "\n" + dabs(1, 60));
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_TRUE(sketch->page);
  EXPECT_EQ(sketch->page->x, -50);
  EXPECT_EQ(sketch->page->y, -5);
  EXPECT_EQ(sketch->page->width, 250);
  EXPECT_EQ(sketch->page->height, 105);
  EXPECT_EQ(x_of(sketch, 0), 10);
  EXPECT_EQ(x_of(sketch, 1), 10);  // the same place, counted from the new corner
}

TEST(Drawpile, KeepsEraserLayersAndOpacity) {
  const Result<Sketch> sketch =
      read(R"(1 layertreecreate {"id":"a","target":""})"
           "\n"
           R"(1 layertreecreate {"id":"c"})"
           "\n"
           R"(1 layertreecreate {"id":"b","target":"a"})"
           "\n"
           R"(1 layerattr {"id":"b","opacity":51})"
           "\n" +
           dabs(1, 1, "svg:dst-out", "a") + dabs(1, 2, "1", "b", "#80ff0000") +
           dabs(1, 3, "1", "c", "#00ff0000"));
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 5u) << "each layer dries before the next";
  const auto stroke = [&](std::size_t i) { return std::get<Stroke>(sketch->items[2 * i]); };
  EXPECT_TRUE(stroke(0).erases);
  EXPECT_EQ(stroke(0).layer, 0);
  EXPECT_EQ(stroke(1).layer, 1);
  EXPECT_NEAR(stroke(1).opacity, 0.2 * 128 / 255, 1e-9);
  EXPECT_EQ(stroke(2).layer, 2);
  EXPECT_EQ(stroke(2).opacity, 1);  // alpha 0: dabs are painted one by one
}

TEST(Drawpile, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> bad[] = {
      {"1 penup {\n", nullptr},
      {"1\n", "a.dptxt:3: a line is: user, message, {members}"},
      {"256 penup {}\n", "a.dptxt:3: the user is outside 0..255"},
      {"-1 penup {}\n", "a.dptxt:3: the user is outside 0..255"},
      {"1 classicdabs {}\n", "a.dptxt:3: no array '_' of dabs"},
      {"1 classicdabs {\"_\":[],\"color\":\"#12\"}\n", "a.dptxt:3: the colour is none"},
      {"1 classicdabs {\"_\":[[1]],\"color\":\"#123456\"}\n", "a.dptxt:3: a dab has no y"},
      {"1 classicdabs {\"_\":[[1,1,-2,1,1]],\"color\":\"#123456\"}\n",
       "a.dptxt:3: size -2 is outside 0..10000000"},
      {"1 classicdabs {\"x\":1e300,\"_\":[]}\n",
       "a.dptxt:3: x 1e+300 is outside -10000000..10000000"},
      {"1 resize {\"right\":-5}\n", "a.dptxt:3: a canvas of -5 x 0 pixels"}};
  for (const auto& [text, message] : bad) {
    const Result<Sketch> sketch = read(text);
    ASSERT_FALSE(sketch) << text;
    if (message != nullptr) {
      EXPECT_EQ(sketch.error().message, message);
    }
  }
  EXPECT_FALSE(read("1 resize {\"right\":NaN}\n"));
}

TEST(Drawpile, IsToldByItsVersion) {
  EXPECT_EQ(format_of(kHead), find_format("drawpile"));
  EXPECT_TRUE(is_drawpile("# first\n!version=dp:4.24.0\n"));
  for (const char* other : {"", "#", "!version=", "1 penup {}", "# x\n0 1 2 3\n"})
    EXPECT_FALSE(is_drawpile(other)) << other;
}

TEST(Drawpile, NoDamageDoesHarm) {
  expect_no_harm_by_damage("drawpile",
                           kHead + R"(1 resize {"right":90,"bottom":9})" + "\n1 undopoint {}\n" +
                               dabs(1, 5) + dabs(2, 7, "0") + "1 undo {}\n",
                           2000);
}

}  // namespace
}  // namespace pentimento::sketch
