#include "core/detail/lock/stale_blocks.h"

#include <gtest/gtest.h>

#include <set>
#include <utility>

namespace pentimento {
namespace {

using Cells = std::set<std::pair<int, int>>;  // x, y

/// A guide of 40 x 24 cells with two layers of two pigments, whose tiles have 16 blocks a side.
class StaleBlocksTest : public ::testing::Test {
 protected:
  StaleBlocksTest() : guide_(make_canvas_state({40, 24, 1, 0.6}, 2, 2, 3, 1.0f)) {
    changed_.add({2, 34, 3, 20});
  }

  Cells find() {
    Cells cells;
    for (const BlockStrip& strip : stale_.find(guide_, changed_, reworked_, threads_)) {
      EXPECT_LT(strip.x0, strip.x1);
      for (int x = strip.x0; x < strip.x1; ++x) {
        EXPECT_EQ(layout_.tile_of(x / layout_.blocks(), strip.y / layout_.blocks()), strip.tile);
        EXPECT_TRUE(cells.emplace(x, strip.y).second) << "twice: " << x << ',' << strip.y;
      }
    }
    return cells;
  }
  static Cells around(int x, int y) {
    Cells cells;
    for (int j = y - 1; j <= y + 1; ++j)
      for (int i = x - 1; i <= x + 1; ++i) cells.emplace(i, j);
    return cells;
  }

  const DetailLayout layout_{{40, 24, 1, 0.6}, 8};
  CanvasState guide_;
  ChangedBlocks changed_{layout_}, reworked_{layout_};
  StaleBlocks stale_{layout_, 2, 2};
  const Threads threads_{3};
};

TEST_F(StaleBlocksTest, WhatTheGuideHoldsAsBeforeIsNotStale) {
  EXPECT_EQ(find(), Cells{});
  guide_.depth_m(9, 9) = 1e-3f;
  EXPECT_EQ(find(), around(9, 9));
  EXPECT_EQ(find(), Cells{});  // it has been noted
}

TEST_F(StaleBlocksTest, EachPlaneOfTheGuideCounts) {
  for (std::size_t plane = 0; plane < guide_.pigment.size(); ++plane) {
    guide_.pigment[plane](12, 7) += 1e-6f;
    EXPECT_EQ(find(), around(12, 7)) << plane;
  }
  guide_.depth_m(12, 7) += 1e-6f;
  EXPECT_EQ(find(), around(12, 7));
}

TEST_F(StaleBlocksTest, ReworkedBlocksAreStaleWhateverTheGuideHolds) {
  reworked_.add({20, 21, 10, 11});
  EXPECT_EQ(find(), around(20, 10));
  EXPECT_EQ(find(), around(20, 10));
  reworked_.clear();
  EXPECT_EQ(find(), Cells{});
}

TEST_F(StaleBlocksTest, NeighboursInOtherTilesAreFoundToo) {
  const int edge = layout_.blocks();
  reworked_.add({edge, edge + 1, edge, edge + 1});
  EXPECT_EQ(find(), around(edge, edge));
}

TEST_F(StaleBlocksTest, NothingBeyondTheChangedBlocksIsListed) {
  reworked_.add({2, 3, 3, 4});  // in their corner
  EXPECT_EQ(find(), (Cells{{2, 3}, {3, 3}, {2, 4}, {3, 4}}));
  // A cell of the guide that is not among them is not looked at.
  reworked_.clear();
  guide_.depth_m(36, 10) = 1e-3f;
  EXPECT_EQ(find(), Cells{});
}

TEST_F(StaleBlocksTest, StripsThatAreHardlyApartAreOne) {
  reworked_.add({5, 6, 8, 9});
  guide_.depth_m(10, 8) = 1e-3f;  // two blocks lie between their neighbours
  Cells joined = around(5, 8);
  joined.merge(around(10, 8));
  for (int y = 7; y <= 9; ++y) {
    joined.emplace(7, y);
    joined.emplace(8, y);
  }
  EXPECT_EQ(find(), joined);
  reworked_.clear();
  reworked_.add({5, 6, 8, 9});
  guide_.depth_m(11, 8) = 1e-3f;  // three
  Cells apart = around(5, 8);
  apart.merge(around(11, 8));
  EXPECT_EQ(find(), apart);
}

TEST_F(StaleBlocksTest, NotedAndClearedGuides) {
  guide_.depth_m(9, 9) = 1e-3f;
  guide_.channel(1, 1)(4, 5) = 1e-3f;
  stale_.note(guide_);
  EXPECT_EQ(find(), Cells{});
  stale_.clear();
  Cells both = around(9, 9);
  both.merge(around(4, 5));
  EXPECT_EQ(find(), both);
}

}  // namespace
}  // namespace pentimento
