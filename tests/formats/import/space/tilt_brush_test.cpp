#include <zip.h>

#include <algorithm>
#include <cmath>

#include "core/base/field.h"
#include "core/optics/srgb.h"
#include "formats/image/read_image.h"
#include "formats/import/read/readers.h"
#include "formats/io/zip_entry.h"
#include "tests/formats/import/recordings.h"
#include "tests/formats/import/space/tilt_file.h"
#include "tests/formats/scratch.h"

namespace pentimento::sketch {
namespace {

Result<Sketch> read_tilt(const std::string& bytes, View view = View::kCamera) {
  ReadOptions options;
  options.view = view;
  return read_tilt_brush({"a.tilt", bytes}, options);
}

/// A painting of these entries, as the program writes it.
std::string painting(const std::string& sketch, const std::string& scene) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.zip");
  zip_t* archive = zip_open(path.c_str(), ZIP_CREATE, nullptr);
  const auto add = [&](const char* name, const std::string& content) {
    zip_file_add(archive, name, zip_source_buffer(archive, content.data(), content.size(), 0), 0);
  };
  add("data.sketch", sketch);
  add("metadata.json", scene);
  EXPECT_EQ(zip_close(archive), 0);
  std::ifstream file(path, std::ios::binary);
  TiltBytes out;
  for (const char c : {'t', 'i', 'l', 'T'}) out.value(c);
  out.value(std::uint16_t{16}).value(std::uint16_t{1}).value(std::uint64_t{0});
  return out.bytes() + std::string(std::istreambuf_iterator<char>(file), {});
}

/// Encoded luminance of a picture, 0..1.
Field<float> luminance_of(const std::array<Field<float>, 3>& rgb) {
  Field<float> out(rgb[0].width(), rgb[0].height(), 0.0f);
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x)
      out(x, y) = static_cast<float>(linear_to_srgb(static_cast<double>(
          0.2126f * rgb[0](x, y) + 0.7152f * rgb[1](x, y) + 0.0722f * rgb[2](x, y))));
  return out;
}

/// The strokes as opaque lines over the ground, each as wide as it is drawn without pressure's
/// part, on a page that is `zoom` times the sketch's.
Field<float> drawn(const Sketch& sketch, int side, double ground, double zoom = 1) {
  const float light = static_cast<float>(ground);
  std::array rgb = {Field<float>(side, side, light), Field<float>(side, side, light),
                    Field<float>(side, side, light)};
  const double pixels = side / (sketch.page->width * zoom);
  for (const Item& item : sketch.items) {
    const Stroke& stroke = std::get<Stroke>(item);
    const double radius = std::max(0.5, stroke.width * pixels / 2);
    const auto dab = [&](double at_x, double at_y) {
      const double x0 = at_x * pixels + side / 2.0, y0 = at_y * pixels + side / 2.0;
      for (int y = std::max(0, static_cast<int>(y0 - radius));
           y < std::min<double>(side, y0 + radius); ++y)
        for (int x = std::max(0, static_cast<int>(x0 - radius));
             x < std::min<double>(side, x0 + radius); ++x)
          if (std::hypot(x + 0.5 - x0, y + 0.5 - y0) <= radius)
            for (std::size_t c = 0; c < 3; ++c) rgb[c](x, y) = static_cast<float>(stroke.color[c]);
    };
    for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
      const Sample& a = stroke.samples[i == 0 ? 0 : i - 1];
      const Sample& b = stroke.samples[i];
      const double steps = 1 + std::floor(std::hypot(b.x - a.x, b.y - a.y) * pixels / radius * 2);
      for (double s = 1; s <= std::min(steps, 1000.0); ++s)
        dab(a.x + (b.x - a.x) * s / steps, a.y + (b.y - a.y) * s / steps);
    }
  }
  return luminance_of(rgb);
}

Field<float> thumbnail_of(const std::string& bytes) {
  const test::Scratch scratch;
  const std::string path = scratch.path("thumbnail.png");
  std::ofstream(path, std::ios::binary)
      << *read_zip_entry({"a", std::string_view(bytes).substr(16)}, "thumbnail.png", 1'000'000);
  return luminance_of(*read_rgb(path));
}

double correlation(const Field<float>& a, const Field<float>& b, bool mirrored = false) {
  double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  const double n = static_cast<double>(a.width()) * a.height();
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const double va = static_cast<double>(a(x, y));
      const double vb = static_cast<double>(b(mirrored ? b.width() - 1 - x : x, y));
      sa += va, sb += vb, saa += va * va, sbb += vb * vb, sab += va * vb;
    }
  }
  return (sab - sa * sb / n) / std::sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

// Drawn as flat lines, each painting resembles its thumbnail most if it is seen as it was: at the
// thumbnail's field of view, neither smaller nor larger, and not as in a mirror. Glow, light and
// texture of the brushes keep the likeness from being 1; the flat painting's furrows do most.
TEST(TiltBrush, IsSeenAsInItsThumbnail) {
  struct Case {
    const char* name;
    double ground, likeness;
  };
  const Case cases[] = {{"Blue_Tit", 0, 0.75},
                        {"OilPaint", 0, 0.1},
                        {"TiltMech", 0, 0.3},
                        {"Liz_Edwards_Portrait", 0.5, 0.75}};
  for (const Case& c : cases) {
    const std::string bytes = recording("tilt-brush/" + std::string(c.name) + ".tilt");
    ASSERT_EQ(format_of(bytes), find_format("tilt-brush"));
    const Result<Sketch> sketch = read_tilt(bytes);
    ASSERT_TRUE(sketch) << sketch.error().message;
    expect_sound(*sketch);
    const Field<float> thumbnail = thumbnail_of(bytes);
    const int side = thumbnail.width();
    const Field<float> seen = drawn(*sketch, side, c.ground);
    const double likeness = correlation(thumbnail, seen);
    EXPECT_GT(likeness, c.likeness) << c.name;
    EXPECT_GT(likeness, correlation(thumbnail, seen, true) + 0.1) << c.name << ": mirrored";
    for (const double zoom : {0.9, 1.1})
      EXPECT_GT(likeness, correlation(thumbnail, drawn(*sketch, side, c.ground, zoom)) + 0.03)
          << c.name << ": a picture " << zoom << " times as wide";
  }
}

constexpr const char* kScene = R"({"BrushIndex":["f72ec0e7-a844-4e38-82e3-140c44772699"],
    "SceneTransformInRoomSpace":[[0,0,0],[0,0,0,1],1],
    "ThumbnailCameraTransformInRoomSpace":[[0,0,-10],[0,0,0,1],1]})";

/// Two strokes on a plane of z, the second nearer to a viewer at negative z.
std::string two_strokes() {
  TiltBytes bytes;
  bytes.head(2);
  bytes.stroke(0, 0.25f, 1).value(0u).value(3u).value(2);
  bytes.point(1, 2, 0, 1, 100).point(3, 2, 0, 1, 200);
  bytes.stroke(0, 0.75f, 1).value(0u).value(3u).value(2);
  bytes.point(1, 4, 5, 1, 50).point(3, 4, 5, 1, 150);
  return bytes.bytes();
}
const Stroke& stroke_of(const Sketch& sketch, std::size_t i) {
  return std::get<Stroke>(sketch.items[i]);
}

TEST(TiltBrush, TheViewDecidesPlacesAndOrder) {
  const std::string bytes = painting(two_strokes(), kScene);
  const Result<Sketch> seen = read_tilt(bytes);
  ASSERT_TRUE(seen) << seen.error().message;
  ASSERT_EQ(seen->items.size(), 2u);
  // The farther one comes first, and is drawn smaller: its depth is 15, that of the other 10.
  EXPECT_NEAR(stroke_of(*seen, 0).color[0], srgb_to_linear(0.75), 1e-12);
  EXPECT_NEAR(stroke_of(*seen, 0).samples[0].y, -4.0 / 15, 1e-7);
  EXPECT_NEAR(stroke_of(*seen, 0).width, 1.0 / 15, 1e-7);
  EXPECT_NEAR(stroke_of(*seen, 1).samples[1].x, 0.3, 1e-7);
  ASSERT_TRUE(seen->page);
  EXPECT_NEAR(seen->page->width, 2 * 0.8391, 1e-4) << "square without a thumbnail";

  const Result<Sketch> front = read_tilt(bytes, View::kFront);
  ASSERT_TRUE(front);
  EXPECT_NEAR(stroke_of(*front, 0).color[0], srgb_to_linear(0.25), 1e-12) << "as in the file";
  EXPECT_DOUBLE_EQ(stroke_of(*front, 1).samples[0].x, 1);
  EXPECT_DOUBLE_EQ(stroke_of(*front, 1).samples[0].y, -4);
  EXPECT_DOUBLE_EQ(stroke_of(*front, 1).samples[0].time_s, 0.05);
  EXPECT_FALSE(front->page);
}

// A flat painting, seen from the side of the camera: x to the right, y upwards, not as in a mirror.
TEST(TiltBrush, ThePlaneIsSeenFromTheCamerasSide) {
  TiltBytes flat;
  flat.head(1).stroke(0, 0, 1).value(0u).value(3u).value(3);
  flat.point(0, 0, 0, 1, 0).point(2, 0, 0, 1, 10).point(2, 1, 0, 1, 20);
  const auto places = [&](double camera_z, const char* turn) {
    const std::string scene = R"({"BrushIndex":["f72ec0e7-a844-4e38-82e3-140c44772699"],
        "ThumbnailCameraTransformInRoomSpace":[[0,0,)" +
                              std::to_string(camera_z) + "]," + turn + ",1]}";
    const Result<Sketch> sketch = read_tilt(painting(flat.bytes(), scene), View::kPlane);
    EXPECT_TRUE(sketch);
    const std::vector<Sample>& at = stroke_of(*sketch, 0).samples;
    return std::array{at[1].x - at[0].x, at[2].y - at[1].y};
  };
  const auto before = places(-10, "[0,0,0,1]"), behind = places(10, "[0,1,0,0]");
  EXPECT_NEAR(before[0], 2, 1e-9);
  EXPECT_NEAR(before[1], -1, 1e-9);
  EXPECT_NEAR(behind[0], -2, 1e-9);
  EXPECT_NEAR(behind[1], -1, 1e-9);
}

TEST(TiltBrush, RefusesOtherHeaders) {
  const auto error = [](const std::string& bytes) { return read_tilt(bytes).error().message; };
  EXPECT_EQ(error("tilT"),
            "a.tilt: offset 4: size of the header is cut short: 2 bytes are needed, 0 are left");
  EXPECT_EQ(error(std::string("tilT\x11\0\1\0", 8) + std::string(8, '\0')),
            "a.tilt: offset 8: header of 17 bytes, version 1: only 16 and 1 are known");
  EXPECT_EQ(error(std::string("tilT\x10\0\1\0", 8) + std::string(8, '\0')),
            "a.tilt: metadata.json: No such file")
      << "an archive without entries";
  EXPECT_EQ(error(painting("x", kScene)),
            "a.tilt: data.sketch: offset 0: sentinel is cut short: 4 bytes are needed, 1 are left");
}

TEST(TiltBrush, NoDamageDoesHarm) {
  expect_no_harm_by_damage("tilt-brush", painting(two_strokes(), kScene), 300);
  expect_no_harm_by_damage("tilt-brush", recording("tilt-brush/OilPaint.tilt"), 20);
}

}  // namespace
}  // namespace pentimento::sketch
