#include "formats/import/space/tilt_brushes.h"

#include <gtest/gtest.h>

#include "formats/import/sketch/text_rows.h"
#include "tests/formats/import/recordings.h"

namespace pentimento::sketch {
namespace {

// The table that was made of the program's own assets.
TEST(TiltBrushes, AreThoseOfTheProgram) {
  const std::string table = recording("tilt-brush/brush-guids.csv");
  std::string_view rest = table;
  next_line(rest);
  int rows = 0;
  while (!rest.empty()) {
    const std::vector<std::string_view> row = fields_of(next_line(rest), ',');
    ASSERT_EQ(row.size(), 6u);
    const std::optional<TiltBrush> brush = tilt_brush(row[0]);
    ASSERT_TRUE(brush) << row[0];
    EXPECT_EQ(brush->name, row[1]);
    EXPECT_EQ(brush->width_share_unpressed, number_of(row[4])) << row[1];
    ++rows;
  }
  EXPECT_EQ(rows, 135);
  EXPECT_FALSE(tilt_brush("00000000-0000-0000-0000-000000000000"));
  EXPECT_FALSE(tilt_brush(""));
}

TEST(TiltBrushes, BecomeTheNearestOfOurs) {
  EXPECT_EQ(kind_of_tilt_brush("Oil Paint"), BrushKind::kFlat);
  EXPECT_EQ(kind_of_tilt_brush("Wet Paint"), BrushKind::kBristle);
  EXPECT_EQ(kind_of_tilt_brush("Marker"), BrushKind::kRound);
  EXPECT_EQ(kind_of_tilt_brush("Ink"), BrushKind::kRound);
  EXPECT_EQ(kind_of_tilt_brush("Tapered Wire"), BrushKind::kRigger);
  EXPECT_EQ(kind_of_tilt_brush(""), BrushKind::kRound);
}

}  // namespace
}  // namespace pentimento::sketch
