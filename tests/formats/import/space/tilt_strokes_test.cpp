#include "formats/import/space/tilt_strokes.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/optics/srgb.h"
#include "formats/import/space/tilt_scene.h"
#include "formats/io/zip_entry.h"
#include "tests/formats/import/recordings.h"
#include "tests/formats/import/space/tilt_file.h"

namespace pentimento::sketch {
namespace {

constexpr std::uint32_t kPressureAndTime = 3;

std::vector<TiltBrush> brushes() {
  return {{"a", "Oil Paint", 0.2}, {"b", "", {}}};
}
Result<std::vector<SpaceStroke>> read(const TiltBytes& bytes) {
  return read_tilt_strokes("in", bytes.bytes(), brushes());
}
std::string error_of(const TiltBytes& bytes) {
  const auto strokes = read(bytes);
  return strokes ? "none" : strokes.error().message;
}

// Counts of their SOURCE.txt.
TEST(TiltStrokes, CountAndLastAsRealPaintingsDo) {
  struct Truth {
    const char* name;
    int strokes, points, untwinned, points_untwinned, span_s;
  };
  const Truth files[] = {{"Blue_Tit", 471, 9403, 295, 6221, 478},
                         {"OilPaint", 67, 1231, 67, 1231, 78},
                         {"TiltMech", 869, 21393, 446, 11165, 2363},
                         {"Liz_Edwards_Portrait", 1952, 37773, 1254, 24433, 10725}};
  for (const Truth& truth : files) {
    const std::string bytes = recording("tilt-brush/" + std::string(truth.name) + ".tilt");
    const ZipBytes archive{truth.name, std::string_view(bytes).substr(16)};
    const auto scene = read_tilt_scene("in", *read_zip_entry(archive, "metadata.json", 1'000'000));
    ASSERT_TRUE(scene);
    const auto strokes = read_tilt_strokes(
        "in", *read_zip_entry(archive, "data.sketch", 10'000'000), scene->brushes);
    ASSERT_TRUE(strokes) << strokes.error().message;
    int points = 0, untwinned = 0, points_untwinned = 0;
    double first_s = 1e18, last_s = 0;
    for (const SpaceStroke& stroke : *strokes) {
      const int count = static_cast<int>(stroke.places.size());
      ASSERT_EQ(stroke.stroke.samples.size(), stroke.places.size());
      points += count;
      untwinned += stroke.twin ? 0 : 1;
      points_untwinned += stroke.twin ? 0 : count;
      first_s = std::min(first_s, stroke.stroke.samples.front().time_s);
      last_s = std::max(last_s, stroke.stroke.samples.back().time_s);
    }
    EXPECT_EQ(static_cast<int>(strokes->size()), truth.strokes) << truth.name;
    EXPECT_EQ(points, truth.points) << truth.name;
    EXPECT_EQ(untwinned, truth.untwinned) << truth.name;
    EXPECT_EQ(points_untwinned, truth.points_untwinned) << truth.name;
    EXPECT_NEAR(last_s - first_s, truth.span_s, 1) << truth.name;
  }
}

TEST(TiltStrokes, TurnTheAxesAndScaleTheWidth) {
  TiltBytes bytes;
  bytes.head(1).stroke(0, 0.5f, 0.25f);
  bytes.value(0b10'0000'0000'0000'0110u).value(kPressureAndTime);  // scale, group, a long one
  bytes.value(2.0f).value(7u).value(3u).value('x').value('y').value('z').value(1);
  const auto strokes = read(bytes.point(1, 2, 3, 0.75f, 1500));
  ASSERT_TRUE(strokes) << strokes.error().message;
  ASSERT_EQ(strokes->size(), 1u);
  const SpaceStroke& read = strokes->front();
  EXPECT_EQ(read.places.front(), Eigen::Vector3d(1, 2, -3));
  EXPECT_DOUBLE_EQ(read.stroke.width, 0.5);
  EXPECT_EQ(read.stroke.width_share_unpressed, 0.2);
  EXPECT_EQ(read.stroke.brush, BrushKind::kFlat);
  EXPECT_DOUBLE_EQ(read.stroke.color[0], srgb_to_linear(0.5));
  EXPECT_DOUBLE_EQ(read.stroke.color[2], 1);
  EXPECT_FLOAT_EQ(read.stroke.samples.front().pressure, 0.75f);
  EXPECT_DOUBLE_EQ(read.stroke.samples.front().time_s, 1.5);
}

TEST(TiltStrokes, AStrokeGoesOnFromItsHeadByLaterDifferences) {
  TiltBytes bytes;
  bytes.head(3);
  for (const auto& stamps :
       {std::array{1000u, 900u, 950u, 940u}, std::array{1000u, 9000u, 9010u, 9020u},
        std::array{1000u, 1010u, 3010u, 3020u}}) {
    bytes.stroke(1, 0, 1).value(0u).value(kPressureAndTime).value(4);
    for (const unsigned ms : stamps) bytes.point(0, 0, 0, 1, ms);
  }
  const auto strokes = read(bytes);
  ASSERT_TRUE(strokes);
  const auto times = [&](std::size_t s) {
    std::vector<int> out;
    for (const Sample& sample : (*strokes)[s].stroke.samples)
      out.push_back(static_cast<int>(std::lround(sample.time_s * 1000)));
    return out;
  };
  EXPECT_EQ(times(0), (std::vector{1000, 1000, 1050, 1050}));
  EXPECT_EQ(times(1), (std::vector{1000, 1000, 1010, 1020}));
  EXPECT_EQ(times(2), (std::vector{1000, 1010, 3010, 3020}));
}

TEST(TiltStrokes, ATwinContinuesTheGroupAtTheSameTime) {
  TiltBytes bytes;
  bytes.head(4);
  const auto add = [&](unsigned flags, unsigned ms) {
    bytes.stroke(1, 0, 1).value(1u).value(kPressureAndTime).value(flags).value(1);
    bytes.point(0, 0, 0, 1, ms);
  };
  add(0, 10), add(2, 10), add(2, 20), add(0, 20);
  const auto strokes = read(bytes);
  ASSERT_TRUE(strokes);
  EXPECT_FALSE((*strokes)[0].twin);
  EXPECT_TRUE((*strokes)[1].twin);
  EXPECT_FALSE((*strokes)[2].twin) << "another time: the group goes on";
  EXPECT_FALSE((*strokes)[3].twin) << "no flag: painted anew";
}

TEST(TiltStrokes, RefusesWhatCannotBe) {
  const auto begun = [] { return TiltBytes().head(1); };
  EXPECT_EQ(error_of(TiltBytes().value(1u)),
            "in: offset 4: data.sketch does not begin with its sentinel");
  EXPECT_EQ(error_of(TiltBytes().head(0, 7)), "in: offset 8: version 7 is not known, only 5 and 6");
  EXPECT_EQ(
      error_of(TiltBytes().head(-1)),
      "in: offset 23: 4294967295 strokes cannot be: 0 bytes are left, each needs at least 36");
  EXPECT_EQ(error_of(begun().stroke(2, 0, 1).value(0u).value(0u).value(0)),
            "in: offset 27: brush 2 of 2");
  EXPECT_EQ(error_of(begun().stroke(-1, 0, 1).value(0u).value(0u).value(0)),
            "in: offset 27: brush -1 of 2");
  EXPECT_EQ(error_of(begun().stroke(0, 0, 2e4f).value(0u).value(0u).value(0)),
            "in: offset 55: width 20000 dm is outside 0..10000");
  EXPECT_EQ(error_of(begun().stroke(0, 0, 1).value(0u).value(0u).value(1 << 31)),
            "in: offset 59: 2147483648 points cannot be: 0 bytes are left, each needs at least 28");
  EXPECT_EQ(error_of(begun().stroke(0, 0, 1).value(0u).value(0u).value(1).place(
                std::numeric_limits<float>::quiet_NaN(), 0, 0)),
            "in: offset 63: position is not finite");
  EXPECT_EQ(error_of(begun().stroke(0, 0, 1).value(0u).value(0u).value(1).place(0, 2e6f, 0)),
            "in: offset 67: position 2000000 dm is over 1000000");
}

}  // namespace
}  // namespace pentimento::sketch
