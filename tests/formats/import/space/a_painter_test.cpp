#include <cstring>

#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

/// Bytes of a painting, value by value.
class Painting {
 public:
  Painting& text(std::string_view words) {
    bytes_ += static_cast<char>(words.size());
    bytes_ += words;
    return *this;
  }
  template <typename T>
  Painting& value(T v) {
    char raw[sizeof(T)];
    std::memcpy(raw, &v, sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  Painting& point(float x, float y, float z, float pressure, std::uint32_t ms) {
    for (const float v : {x, y, z, 0.0f, 0.0f, 0.0f, 1.0f, pressure}) value(v);
    return value(ms);
  }
  Painting& stroke(std::uint8_t brush, float red, float size, std::uint32_t points) {
    value(brush).value(red).value(0.0f).value(1.0f);
    return value(size).value(points);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};
Painting head(std::uint32_t strokes, std::uint16_t version = 1) {
  Painting out;
  out.text("apainter").value(version).value(std::uint8_t{2}).text("smooth").text("line");
  out.value(strokes);
  return out;
}
Result<Sketch> read(const std::string& bytes, View view = View::kCamera) {
  ReadOptions options;
  options.view = view;
  return read_a_painter({"a.apa", bytes}, options);
}

// Counts of their SOURCE.txt.
TEST(APainter, ReadsRealPaintings) {
  const std::tuple<const char*, int, int, float> files[] = {{"dancer", 101, 6298, 516.2f},
                                                            {"rose_bush", 229, 4837, 804.5f},
                                                            {"the_leap", 206, 8808, 799.0f},
                                                            {"mozfest", 43, 2091, 103.8f}};
  for (const auto& [name, strokes, points, span_s] : files) {
    const std::string bytes = recording("a-painter/" + std::string(name) + ".apa");
    ASSERT_EQ(format_of(bytes), find_format("a-painter"));
    const Result<Sketch> sketch = read(bytes);
    ASSERT_TRUE(sketch) << sketch.error().message;
    expect_sound(*sketch);
    EXPECT_EQ(counts_of(*sketch).strokes, strokes) << name;
    EXPECT_EQ(counts_of(*sketch).samples, points) << name;
    double first = 1e9, last = 0;
    float least = 1;
    for (const Item& item : sketch->items) {
      for (const Sample& s : std::get<Stroke>(item).samples) {
        first = std::min(first, s.time_s);
        last = std::max(last, s.time_s);
        least = std::min(least, s.pressure);
      }
    }
    EXPECT_NEAR(last - first, static_cast<double>(span_s), 0.06) << name;
    EXPECT_GE(least, 0.1f) << name;
  }
}

TEST(APainter, SeesTheFrontUprightWithColourSizeAndTime) {
  const std::string bytes = head(1)
                                .stroke(1, 1.0f, 0.25f, 3)
                                .point(0, 1, 5, 0.5f, 1000)
                                .point(2, 1, 5, 1, 1500)
                                .point(2, 3, 5, 1, 1400)
                                .bytes();
  const Result<Sketch> sketch = read(bytes, View::kFront);
  ASSERT_TRUE(sketch) << sketch.error().message;
  const auto& stroke = std::get<Stroke>(sketch->items.at(0));
  EXPECT_EQ(stroke.color, (log::Rgb{1, 0, 1}));
  EXPECT_EQ(stroke.width, 0.25);
  EXPECT_EQ(stroke.brush, BrushKind::kRigger);
  EXPECT_EQ(stroke.samples[1].x, 2);
  EXPECT_EQ(stroke.samples[1].y, -1);
  EXPECT_EQ(stroke.samples[1].time_s, 1.5);
  EXPECT_EQ(stroke.samples[2].time_s, 1.5);  // a clock that was set back
  const Result<Sketch> plane = read(bytes);
  ASSERT_TRUE(plane);
  const std::vector<Sample>& seen = std::get<Stroke>(plane->items.at(0)).samples;
  EXPECT_NEAR(seen[1].x - seen[0].x, 2, 1e-6);
  EXPECT_NEAR(seen[2].y - seen[1].y, -2, 1e-6);
}

TEST(APainter, SaysWhatIsWrongAndWhere) {
  const std::pair<std::string, const char*> bad[] = {
      {head(0, 7).bytes(), "version 7 is not known, only 1"},
      {head(0xffffffffu).bytes(), "4294967295 strokes cannot be"},
      {head(1).stroke(5, 1, 1, 0).bytes() + std::string(40, '\0'), "brush 5 of 2"},
      {head(1).stroke(0, 1, -1, 0).bytes(), "size -1 m is outside"},
      {head(1).stroke(0, 1, 1, 0x80000000u).bytes(), "points cannot be"},
      {head(1).stroke(0, 1, 1, 1).point(NAN, 0, 0, 1, 0).bytes(), "position is not finite"},
      {head(1).stroke(0, 1, 1, 1).point(1e9f, 0, 0, 1, 0).bytes(), "is over 1000000"},
      {"hello", "not a painting of A-Painter"}};
  for (const auto& [bytes, message] : bad) {
    const Result<Sketch> sketch = read(bytes);
    ASSERT_FALSE(sketch) << message;
    EXPECT_NE(sketch.error().message.find(message), std::string::npos) << sketch.error().message;
    EXPECT_TRUE(sketch.error().message.starts_with("a.apa: offset ")) << sketch.error().message;
  }
}

TEST(APainter, NoDamageDoesHarm) {
  expect_no_harm_by_damage("a-painter", recording("a-painter/mozfest.apa"), 100);
}

}  // namespace
}  // namespace pentimento::sketch
