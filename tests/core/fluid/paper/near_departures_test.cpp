// Groups of cells whose paint comes from next to one another.

#include "core/fluid/paper/near_departures.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

constexpr int kDriftWidth = 150, kDriftHeight = 9, kDriftRow = 4;

/// A group whose paint drifts evenly along x, but for one cell.
struct Drift {
  Drift() : canvas(kDriftWidth, kDriftHeight) {
    const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                       canvas.contact, canvas.amount,  canvas.threads};
    k = make_step_constants(canvas.state.geometry, in);
  }
  /// The group at column x, with cells that come so far; the fourth cell comes `other_cells` far
  /// along x and `other_rows` along y.
  const NearGroup& group(int x, float cells, float other_cells, float other_rows = 0) {
    std::vector<float> u(kDriftWidth, cells * k.dx_m / k.dt_s), v(kDriftWidth, 0);
    u[static_cast<std::size_t>(x) + 3] = other_cells * k.dx_m / k.dt_s;
    v[static_cast<std::size_t>(x) + 3] = other_rows * k.dy_m / k.dt_s;
    found.groups = 1;
    found.group[0].x = x;
    find_near(k, {kDriftRow, shape_of(canvas.state.depth_m), u.data(), v.data()}, found);
    return found.group[0];
  }
  TestCanvas canvas;
  StepConstants k;
  NearDepartures found;
};

TEST(NearDepartures, PaintThatMovesAlikeComesFromThreeColumnsAndRows) {
  Drift drift;
  EXPECT_EQ(drift.group(40, 0.5f, -0.5f).side, kNearSide);
  EXPECT_EQ(drift.found.group[0].shift_x, -1);
  EXPECT_EQ(drift.found.group[0].shift_y, 0);
  EXPECT_EQ(drift.found.choice[2] & kFirstColumnBit, kFirstColumnBit);
  EXPECT_EQ(drift.found.choice[3] & (kFirstColumnBit | kThirdColumnBit), 0);  // the second
  EXPECT_EQ(drift.group(40, 5.25f, 4.5f).side, kNearSide);
  EXPECT_EQ(drift.found.group[0].shift_x, -6);
  EXPECT_FLOAT_EQ(drift.found.fx[0], 0.75f);
}

TEST(NearDepartures, FourColumnsAndRowsAreWide) {
  Drift drift;
  EXPECT_EQ(drift.group(40, 1.5f, -0.5f).side, kWideSide);
  EXPECT_EQ(drift.found.group[0].shift_x, -2);
  EXPECT_EQ(drift.found.choice[3] & kThirdColumnBit, kThirdColumnBit);
  EXPECT_EQ(drift.group(40, 0.5f, 0.5f, -2.5f).side, kWideSide);  // from two rows below
  EXPECT_EQ(drift.found.group[0].shift_y, 0);
  EXPECT_EQ(drift.found.choice[3] & kThirdRowBit, kThirdRowBit);
  EXPECT_EQ(drift.group(40, 0.5f, 0.5f, 1.5f).side, kWideSide);  // and from above
  EXPECT_EQ(drift.found.group[0].shift_y, -2);
}

TEST(NearDepartures, NoSideFartherApart) {
  Drift drift;
  EXPECT_EQ(drift.group(40, 2.5f, -0.5f).side, 0);
  EXPECT_EQ(drift.group(40, -0.5f, 2.5f).side, 0);
  EXPECT_EQ(drift.group(40, 0.5f, 0.5f, 3.5f).side, 0);
  EXPECT_EQ(drift.group(40, 20, -20).side, 0);
}

TEST(NearDepartures, NoSideBeyondTheCanvas) {
  Drift drift;
  EXPECT_EQ(drift.group(6, 5.25f, 4.5f).side, kNearSide);
  EXPECT_EQ(drift.group(5, 5.25f, 4.5f).side, 0);  // a column before the canvas
  // Cells up to 132 + 15, and two columns more, of 150.
  EXPECT_EQ(drift.group(132, -0.5f, -0.25f).side, kNearSide);
  EXPECT_EQ(drift.group(133, -0.5f, -0.25f).side, 0);
}

// What does not move has no say in where the others come from.
TEST(NearDepartures, PaintThatStandsComesFromNowhere) {
  Drift drift;
  EXPECT_EQ(drift.group(40, 5.25f, 0).side, kNearSide);
  EXPECT_EQ(drift.found.group[0].shift_x, -6);
  EXPECT_EQ(drift.found.choice[3] & kMovesBit, 0);
  EXPECT_NE(drift.found.choice[2] & kMovesBit, 0);
  EXPECT_EQ(drift.group(40, 0, 0).side, kNearSide);
}

// Every cell is in a group or is gone through plainly, and no cell of a group lies at the border.
TEST(NearDepartures, RangesAreCoveredByGroupsAndPlainCells) {
  Drift drift;
  const std::vector<float> still(400, 0);
  for (const int width : {1, 2, 17, 18, 19, 150, 400})
    for (const Columns cells : {Columns{0, width}, Columns{1, width}, Columns{width / 2, width / 2},
                                Columns{0, 1}, Columns{width / 3, width}}) {
      std::vector<int> done(static_cast<std::size_t>(width), 0);
      const NearRow row{0, {width, kDriftHeight, 400}, still.data(), still.data()};
      for_near_cells(
          drift.k, row, cells,
          [&](const NearDepartures& from) {
            ASSERT_LE(from.groups, kMostGroups);
            for (int g = 0; g < from.groups; ++g) {
              const NearGroup& group = from.group[static_cast<std::size_t>(g)];
              ASSERT_NE(group.side, 0);
              ASSERT_GE(group.x, std::max(cells.begin, 1));
              ASSERT_LE(group.x + kGroupCells, std::min(cells.end, width - 1));
              for (int i = 0; i < kGroupCells; ++i) done[static_cast<std::size_t>(group.x + i)] = 1;
            }
          },
          [&](int begin, int end) {
            for (int x = begin; x < end; ++x) ++done[static_cast<std::size_t>(x)];
          });
      for (int x = 0; x < width; ++x)
        EXPECT_EQ(done[static_cast<std::size_t>(x)], x >= cells.begin && x < cells.end ? 1 : 0)
            << "column " << x << " of " << width;
    }
}

}  // namespace
}  // namespace pentimento::paper
