#include <algorithm>

#include "formats/import/read/readers.h"
#include "tests/formats/import/recordings.h"
#include "tests/formats/import/wacom/uim_file.h"

namespace pentimento::sketch {
namespace {

Sketch drawing(const std::string& file) {
  const std::string bytes = recording("wacom-uim/" + file);
  EXPECT_EQ(format_of(bytes), find_format("wacom")) << file;
  Result<Sketch> sketch = read_wacom({file, bytes}, {});
  EXPECT_TRUE(sketch) << sketch.error().message;
  if (!sketch) return {};
  expect_sound(*sketch);
  return std::move(*sketch);
}
const Stroke& stroke_of(const Sketch& sketch, std::size_t i) {
  return std::get<Stroke>(sketch.items[i]);
}

// Counts of their SOURCE.txt. Of different-input-providers 8 of 24 recordings, with 410 of 1466
// samples, are of strokes that were erased.
TEST(Wacom, CountsAndRangesAreThoseOfRealFiles) {
  struct Truth {
    const char* file;
    int strokes, samples;
    double span_s;
    float most_pressure;
  };
  const Truth files[] = {{"digital-ink-processable-3.0.json", 177, 2787, 286.5, 0.96f},
                         {"digital-ink-processable-3.0.uim", 177, 2787, 286.5, 0.96f},
                         {"hello-world.uim", 623, 15208, 2221, 1},
                         {"raster-brushes.uim", 4, 124, 12.1, 0.66f},
                         {"different-input-providers.uim", 16, 1056, 0, 0.75f}};
  for (const Truth& truth : files) {
    const Sketch sketch = drawing(truth.file);
    EXPECT_EQ(counts_of(sketch).strokes, truth.strokes) << truth.file;
    EXPECT_EQ(counts_of(sketch).samples, truth.samples) << truth.file;
    double first_s = 1e18, last_s = 0;
    float most = 0;
    for (const Item& item : sketch.items) {
      for (const Sample& s : std::get<Stroke>(item).samples) {
        first_s = std::min(first_s, s.time_s);
        last_s = std::max(last_s, s.time_s);
        most = std::max(most, s.pressure);
      }
    }
    if (truth.span_s > 0) {
      EXPECT_NEAR(last_s - first_s, truth.span_s, 0.5) << truth.file;
    }
    EXPECT_NEAR(most, truth.most_pressure, 0.005f) << truth.file;
  }
  EXPECT_EQ(counts_of(drawing("digital-ink-processable.uim")).strokes, 178);
  EXPECT_EQ(counts_of(drawing("digital-ink-processable.uim")).samples, 2789);
}

// One drawing in three encodings: 3.1 has whole hundredths of a pixel, and a stroke more.
TEST(Wacom, ThreeEncodingsOfADrawingAreOneDrawing) {
  const Sketch json = drawing("digital-ink-processable-3.0.json");
  const Sketch old = drawing("digital-ink-processable-3.0.uim");
  const Sketch now = drawing("digital-ink-processable.uim");
  ASSERT_EQ(json.items.size(), old.items.size());
  ASSERT_EQ(old.items.size() + 1, now.items.size());
  for (std::size_t i = 0; i < old.items.size(); ++i) {
    const Stroke &a = stroke_of(json, i), &b = stroke_of(old, i), &c = stroke_of(now, i);
    ASSERT_EQ(a.samples.size(), b.samples.size());
    ASSERT_EQ(b.samples.size(), c.samples.size());
    EXPECT_NEAR(a.width, b.width, 1e-6);
    EXPECT_NEAR(b.width, c.width, 0.006);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(a.color[k], b.color[k]);
      EXPECT_NEAR(b.color[k], c.color[k], 1e-6);
    }
    for (std::size_t s = 0; s < a.samples.size(); ++s) {
      const Sample &p = a.samples[s], &q = b.samples[s], &r = c.samples[s];
      EXPECT_NEAR(p.x, q.x, 1e-4);
      EXPECT_NEAR(p.y, q.y, 1e-4);
      EXPECT_NEAR(q.x, r.x, 0.006);
      EXPECT_NEAR(q.y, r.y, 0.006);
      EXPECT_EQ(p.time_s, q.time_s);
      EXPECT_EQ(q.time_s, r.time_s);
      EXPECT_EQ(p.pressure, r.pressure);
      EXPECT_EQ(p.tilt_x_deg, r.tilt_x_deg);
    }
  }
}

std::string error_of(const std::string& bytes) {
  const Result<Sketch> sketch = read_wacom({"a.uim", bytes}, {});
  return sketch ? "none" : sketch.error().message;
}

TEST(Wacom, RefusesWhatItCannotRead) {
  const auto with_head = [](const std::string& head, const std::string& more = "") {
    return riff_of(chunk_of("HEAD", head) + more);
  };
  const std::string good = std::string({3, 1, 0, 0}) + about_chunk();
  EXPECT_EQ(error_of(with_head({3, 2, 0, 0})),
            "a.uim: offset 2: version 3.2 is not known, only 3.0 and 3.1");
  EXPECT_EQ(error_of(with_head(good)), "a.uim: offset 32: there is no chunk INKD");
  EXPECT_EQ(error_of(with_head(std::string({3, 1, 0, 0}) + about_chunk(2), chunk_of("INKD", ""))),
            "a.uim: offset 40: content 2 of the chunk INKD is not known, only 1");
  EXPECT_EQ(
      error_of(with_head(std::string({3, 1, 0, 0}) + about_chunk(1, 2), chunk_of("INKD", ""))),
      "a.uim: offset 40: the chunk INKD is compressed, which is not read");
  EXPECT_EQ(error_of(with_head(good, "INKD" + u32_bytes(1u << 31))),
            "a.uim: offset 40: 2147483648 bytes of a chunk cannot be: 0 bytes are left, each needs "
            "at least 1");
}

TEST(Wacom, HasALimit) {
  const std::string large = "RIFF" + std::string(33u << 20, '\0');
  const Result<Sketch> sketch = read_wacom({"a.uim", large}, {});
  ASSERT_FALSE(sketch);
  EXPECT_EQ(sketch.error().code, ErrorCode::kLimit);
  EXPECT_EQ(sketch.error().message, "a.uim: 34603012 bytes are over 33554432");
}

TEST(Wacom, NoDamageDoesHarm) {
  expect_no_harm_by_damage("wacom", recording("wacom-uim/raster-brushes.uim"), 50);
  const std::string json = recording("wacom-uim/digital-ink-processable-3.0.json");
  expect_no_harm_by_damage("wacom", recording("wacom-uim/different-input-providers.uim"), 300);
  for (const std::size_t percent : {20u, 60u, 99u})
    expect_no_harm(*find_format("wacom"), json.substr(0, json.size() * percent / 100), "JSON");
}

}  // namespace
}  // namespace pentimento::sketch
