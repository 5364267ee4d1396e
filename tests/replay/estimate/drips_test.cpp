#include "replay/estimate/drips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace pentimento {
namespace {

/// Cells that a patch of thin paint reaches, x 20 to 59 and y 20 to 39 of a canvas of 100 x 200
/// cells of 1 mm.
std::set<std::pair<int, int>> reached(const TiltedTime& tilted,
                                      const CellBox& among = {0, 100, 0, 200}) {
  std::set<std::pair<int, int>> cells;
  for_drips(
      {100, 200, 0.1, 0.2}, among, tilted,
      [](int x, int y) { return x >= 20 && x < 60 && y >= 20 && y < 40; },
      [&](int, int, int x, int y) { cells.emplace(x, y); });
  return cells;
}

TiltedTime tilted(double x_m_s2, double y_m_s2, double time_s) {
  TiltedTime time;
  time.tilt(x_m_s2, y_m_s2, 1);
  time.pass(1 + time_s);
  return time;
}

TEST(Drips, AFlatCanvasHasNone) {
  EXPECT_TRUE(reached(TiltedTime()).empty());
  EXPECT_TRUE(reached(tilted(0, 0, 10)).empty());
}

TEST(Drips, ASheetAndBelowItDripsApart) {
  const auto cells = reached(tilted(0, 9.81, 100));
  int sheet = 0, drips = 0;
  for (int x = 0; x < 100; ++x) {
    sheet += cells.count({x, 39 + 17}) > 0 ? 1 : 0;  // 0.85 of 20
    drips += cells.count({x, 39 + 60}) > 0 ? 1 : 0;
    EXPECT_EQ(cells.count({x, 39 + 61}), 0u);
    EXPECT_EQ(cells.count({x, 39}), 0u);  // the patch itself is not told
  }
  EXPECT_EQ(sheet, 40);
  EXPECT_GE(drips, 8);  // two or three of 4 cells in 40
  EXPECT_LE(drips, 12);
}

TEST(Drips, TakeTheirTime) {
  const auto cells = reached(tilted(0, 9.81, 2));
  int lowest = 0;
  for (const auto& [x, y] : cells) lowest = std::max(lowest, y);
  EXPECT_EQ(lowest, 39 + 32);  // 16 mm a second
}

TEST(Drips, RunWhereGravityPulls) {
  for (const auto& [x, y] : reached(tilted(9.81, 0, 1))) {
    EXPECT_GE(x, 60);
    EXPECT_GE(y, 20);
    EXPECT_LT(y, 40);
  }
}

TEST(Drips, OnlyTheGivenCellsAreLookedAt) {
  // The lower edge of the patch is row 39.
  EXPECT_TRUE(reached(tilted(0, 9.81, 2), {0, 100, 0, 39}).empty());
  EXPECT_TRUE(reached(tilted(0, 9.81, 2), {60, 100, 0, 200}).empty());
  EXPECT_EQ(reached(tilted(0, 9.81, 2), {20, 60, 20, 40}), reached(tilted(0, 9.81, 2)));
}

TEST(Drips, TiltingThereAndBackIsNoWay) {
  TiltedTime time;
  time.tilt(0, 9.81, 0);
  time.tilt(0, -9.81, 4);
  time.pass(8);
  EXPECT_NEAR(time.y_s(), 0, 1e-12);
  time.tilt(0, 9.81, 8);
  time.pass(9);
  EXPECT_NEAR(time.y_s(), 1, 1e-12);
  time.forget();
  EXPECT_EQ(time.y_s(), 0);
}

}  // namespace
}  // namespace pentimento
