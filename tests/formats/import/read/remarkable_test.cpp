#include <cstring>

#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

/// Bytes of a page, value by value.
class PageBytes {
 public:
  explicit PageBytes(int version) {
    bytes_ = "reMarkable .lines file, version=" + std::to_string(version);
    bytes_.resize(43, ' ');
  }
  PageBytes() = default;
  template <typename T>
  PageBytes& value(T v) {
    char raw[sizeof(T)];
    std::memcpy(raw, &v, sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  PageBytes& word(std::uint32_t v) { return value(v); }
  PageBytes& point(float x, float y, float width, float pressure) {
    for (const float v : {x, y, 1.0f, 2.0f, width, pressure}) value(v);
    return *this;
  }
  PageBytes& short_point(float x, float y, std::uint16_t width, std::uint8_t pressure) {
    return value(x)
        .value(y)
        .value(std::uint16_t{4})
        .value(width)
        .value(std::uint8_t{9})
        .value(pressure);
  }
  PageBytes& id(std::uint8_t index, std::uint8_t part, std::uint8_t number) {
    return value(static_cast<std::uint8_t>(index << 4 | 15)).value(part).value(number);
  }
  PageBytes& part(std::uint8_t index, const PageBytes& of) {
    value(static_cast<std::uint8_t>(index << 4 | 12));
    value(static_cast<std::uint32_t>(of.bytes_.size()));
    bytes_ += of.bytes_;
    return *this;
  }
  PageBytes& tagged_word(std::uint8_t index, std::uint32_t v) {
    // A tag of more than seven bits has a second byte.
    const int tag = index << 4 | 4;
    if (tag < 128) return value(static_cast<std::uint8_t>(tag)).value(v);
    return value(static_cast<std::uint8_t>((tag & 127) | 128))
        .value(static_cast<std::uint8_t>(tag >> 7))
        .value(v);
  }
  PageBytes& block(std::uint8_t type, std::uint8_t version, const PageBytes& of) {
    value(static_cast<std::uint32_t>(of.bytes_.size())).value(std::uint8_t{0});
    value(std::uint8_t{1}).value(version).value(type);
    bytes_ += of.bytes_;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

Result<Sketch> read(const std::string& bytes) {
  return read_remarkable({"a.rm", bytes}, {});
}
const Stroke& stroke(const Result<Sketch>& sketch, std::size_t i) {
  return std::get<Stroke>(sketch->items.at(i));
}

// Counts of their SOURCE.txt.
TEST(Remarkable, ReadsRealPages) {
  const std::tuple<const char*, int, int> files[] = {{"all-pens-v5", 185, 4309},
                                                     {"empty-v5", 0, 0},
                                                     {"colour-and-tool-v6", 25, 1370},
                                                     {"lines-with-text-v6", 10, 469},
                                                     {"two-layers-line-v1-v6", 2, 14}};
  for (const auto& [name, strokes, points] : files) {
    const std::string bytes = recording("remarkable/" + std::string(name) + ".rm");
    ASSERT_EQ(format_of(bytes), find_format("remarkable")) << name;
    const Result<Sketch> sketch = read(bytes);
    ASSERT_TRUE(sketch) << name << sketch.error().message;
    expect_sound(*sketch);
    EXPECT_EQ(counts_of(*sketch).strokes, strokes) << name;
    EXPECT_EQ(counts_of(*sketch).samples, points) << name;
  }
}

TEST(Remarkable, APageOfVersionFiveHasItsPensWidthsAndPlaces) {
  const Result<Sketch> sketch = read(recording("remarkable/all-pens-v5.rm"));
  ASSERT_TRUE(sketch) << sketch.error().message;
  int erasers = 0;
  double left = 1e9, right = 0, top = 1e9, bottom = 0, widest = 0;
  for (const Item& item : sketch->items) {
    const auto& s = std::get<Stroke>(item);
    erasers += s.erases ? 1 : 0;
    widest = std::max(widest, s.width);
    for (const Sample& p : s.samples) {
      left = std::min(left, p.x);
      right = std::max(right, p.x);
      top = std::min(top, p.y);
      bottom = std::max(bottom, p.y);
    }
  }
  EXPECT_EQ(erasers, 9);
  EXPECT_NEAR(widest, 54, 1);
  EXPECT_NEAR(left, 217.8, 0.05);
  EXPECT_NEAR(right, 950.8, 0.05);
  EXPECT_NEAR(top, 64.6, 0.05);
  EXPECT_NEAR(bottom, 1807.2, 0.05);
  ASSERT_TRUE(sketch->page);
  EXPECT_EQ(sketch->page->width, 1404);
  EXPECT_EQ(sketch->page->height, 1872);
}

TEST(Remarkable, PagesOfVersionSixCountFromTheMiddleAndMayBeScrolled) {
  const Result<Sketch> colours = read(recording("remarkable/colour-and-tool-v6.rm"));
  ASSERT_TRUE(colours && colours->page);
  EXPECT_EQ(colours->page->x, -810);
  EXPECT_EQ(colours->page->width, 1620);
  // A group that hangs on a text has places above the page.
  const Result<Sketch> text = read(recording("remarkable/lines-with-text-v6.rm"));
  ASSERT_TRUE(text);
  EXPECT_FALSE(text->page);
}

TEST(Remarkable, ReadsVersionThreeWhichHasAWordLess) {
  const Result<Sketch> sketch = read(PageBytes(3)
                                         .word(1)
                                         .word(1)
                                         .word(17)
                                         .word(1)
                                         .word(0)
                                         .value(2.0f)
                                         .word(2)
                                         .point(10, 20, 3, 0.5f)
                                         .point(11, 21, 4, 1.5f)
                                         .bytes());
  ASSERT_TRUE(sketch) << sketch.error().message;
  const Stroke& line = stroke(sketch, 0);
  EXPECT_EQ(line.brush, BrushKind::kRigger);
  EXPECT_EQ(line.width, 4);
  EXPECT_EQ(line.samples[0].pressure, 0.5f);
  EXPECT_EQ(line.samples[1].pressure, 1.0f);
  EXPECT_NEAR(line.color[0], 0.205, 0.005);  // grey
  EXPECT_FALSE(line.timed);
}

PageBytes line_at(std::uint8_t number, std::uint8_t left, float x, bool deleted = false) {
  PageBytes points, body, out;
  points.short_point(x, 5, 8, 255);
  body.value(std::uint8_t{3}).tagged_word(1, 15).tagged_word(2, 9).part(5, points);
  body.tagged_word(8, 0xff0000ff);
  out.id(1, 0, 11).id(2, 1, number).id(3, left == 0 ? 0 : 1, left).id(4, 0, 0);
  return deleted ? out : out.part(6, body);
}

TEST(Remarkable, LinesFollowTheirLeftNeighboursNotTheFile) {
  const Result<Sketch> sketch = read(PageBytes(6)
                                         .block(5, 2, line_at(1, 0, 1))
                                         .block(5, 2, line_at(2, 1, 4))
                                         .block(5, 2, line_at(3, 1, 2))
                                         .block(5, 2, line_at(4, 3, 9, true))
                                         .block(5, 2, line_at(5, 4, 3))
                                         .bytes());
  ASSERT_TRUE(sketch) << sketch.error().message;
  ASSERT_EQ(sketch->items.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(stroke(sketch, i).samples[0].x, static_cast<double>(i + 1));
  EXPECT_EQ(stroke(sketch, 0).color, (log::Rgb{0, 0, 1}));
  EXPECT_EQ(stroke(sketch, 0).width, 2);
  EXPECT_EQ(sketch->report.dropped.back(), "1 deleted lines");
}

TEST(Remarkable, SaysWhatIsWrongAndWhere) {
  PageBytes odd;
  odd.value(std::uint8_t{0x12});
  const std::pair<std::string, const char*> bad[] = {
      {PageBytes(4).bytes(), "version 4 is not known, only 3, 5 and 6"},
      {PageBytes(5).word(0xffffffff).bytes(), "4294967295 layers cannot be"},
      {PageBytes(5)
           .word(1)
           .word(1)
           .word(0)
           .word(0)
           .word(0)
           .value(1.0f)
           .word(0)
           .word(1)
           .point(NAN, 0, 1, 1)
           .bytes(),
       "x is not finite"},
      {PageBytes(5)
           .word(1)
           .word(1)
           .word(0)
           .word(0)
           .word(0)
           .value(1.0f)
           .word(0)
           .word(1)
           .point(1e9f, 0, 1, 1)
           .bytes(),
       "is over 1000000 px"},
      {PageBytes(6).word(1000).word(0).bytes(), "block is cut short"},
      {PageBytes(6).block(5, 2, odd).bytes(), "a value of kind 2 is not known"},
      {"hello", "head is cut short"},
      {std::string(50, 'x'), "not a page of a reMarkable"}};
  for (const auto& [bytes, message] : bad) {
    const Result<Sketch> sketch = read(bytes);
    ASSERT_FALSE(sketch) << message;
    EXPECT_NE(sketch.error().message.find(message), std::string::npos) << sketch.error().message;
    EXPECT_TRUE(sketch.error().message.starts_with("a.rm: offset ")) << sketch.error().message;
  }
}

TEST(Remarkable, NoDamageDoesHarm) {
  expect_no_harm_by_damage("remarkable", recording("remarkable/colour-and-tool-v6.rm"), 200);
  expect_no_harm_by_damage("remarkable", recording("remarkable/all-pens-v5.rm").substr(0, 30000),
                           200);
}

}  // namespace
}  // namespace pentimento::sketch
