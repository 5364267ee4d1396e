#include "core/fluid/conservative/tiles/wet_cells.h"

#include <gtest/gtest.h>

#include <string>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

/// 256 x 64 cells in 16 x 4 tiles, all awake but those in `asleep`.
class WetCellsTest : public ::testing::Test {
 protected:
  WetCellsTest() : b_({256, 64, 0.256, 0.064}), tiles_(b_.state.geometry, 0.016f) {
    b_.state.sleep.assign(static_cast<std::size_t>(tiles_.count()) * kSleepValues, 0);
  }
  void put_to_sleep(int tile) {
    b_.state.sleep[static_cast<std::size_t>(tile) * kSleepValues + kAsleep] = 1;
  }
  const WetCells& find(int reach) {
    tiles_.wake(b_.state, {b_.model, b_.gravity_m_s2, b_.dt_s, b_.contact, b_.amount, b_.pool});
    wet_.find(tiles_, b_.state.depth_m, reach, b_.pool);
    return wet_;
  }
  std::string row(int y) const {
    std::string out;
    for (const auto& r : wet_.runs())
      if (r.y == y) out += std::to_string(r.x0) + "-" + std::to_string(r.x1) + " ";
    return out;
  }
  static std::string text(const std::vector<CellBox>& boxes) {
    std::string out;
    for (const CellBox& b : boxes)
      out += std::to_string(b.x0) + "-" + std::to_string(b.x1) + " x " + std::to_string(b.y0) +
             "-" + std::to_string(b.y1) + "; ";
    return out;
  }

  Basin b_;
  SleepTiles tiles_;
  WetCells wet_;
};

TEST_F(WetCellsTest, ABareCanvasHasNone) {
  EXPECT_TRUE(find(3).runs().empty());
  EXPECT_TRUE(wet_.boxes().empty());
}

TEST_F(WetCellsTest, LieWithinReachOfPaintInWholeVectorsAndFourRows) {
  b_.state.depth_m(100, 21) = 1e-3f;
  find(3);
  EXPECT_EQ(row(15), "");
  EXPECT_EQ(row(16), "96-112 ");
  EXPECT_EQ(row(24), "96-112 ") << "three rows below";
  EXPECT_EQ(row(27), "96-112 ") << "and the rest of its four";
  EXPECT_EQ(row(28), "");
  b_.state.depth_m(100, 21) = 0;
  b_.state.depth_m(98, 20) = 1e-3f;  // three from column 95
  find(3);
  EXPECT_EQ(row(20), "80-112 ");
  EXPECT_EQ(row(16), "80-112 ");
  EXPECT_EQ(row(15), "");
  find(2);
  EXPECT_EQ(row(20), "96-112 ");
}

TEST_F(WetCellsTest, EndAtTheCanvasAndWhereItSleeps) {
  b_.state.depth_m(0, 0) = b_.state.depth_m(255, 63) = 1e-3f;
  b_.state.depth_m(127, 32) = 1e-3f;  // in tile (7, 2)
  put_to_sleep(2 * 16 + 8);
  find(15);
  EXPECT_EQ(row(0), "0-16 ");
  EXPECT_EQ(row(63), "240-256 ");
  EXPECT_EQ(row(32), "112-128 ");
  put_to_sleep(2 * 16 + 7);
  find(16);
  EXPECT_EQ(row(32), "96-112 ") << "seen from where it is awake";
}

TEST_F(WetCellsTest, KeepNarrowGaps) {
  b_.state.depth_m(8, 8) = b_.state.depth_m(72, 8) = 1e-3f;
  find(0);
  EXPECT_EQ(row(8), "0-80 ") << "48 cells lie between";
  b_.state.depth_m(72, 8) = 0;
  b_.state.depth_m(88, 8) = 1e-3f;
  find(0);
  EXPECT_EQ(row(8), "0-16 80-96 ");
}

TEST_F(WetCellsTest, LieWhereTheBrushPushesPaintTo) {
  b_.contact.weight(40, 30) = 1;
  b_.contact.push_x_m(40, 30) = 0.0205f;
  b_.contact.touch(40, 41, 30, 31);
  find(3);
  // 20 cells and a part of one, then three of sleep's reach and three of this one.
  EXPECT_EQ(tiles_.touched().x1, 42 + 23);
  EXPECT_EQ(row(30), "0-80 ");
}

TEST_F(WetCellsTest, AreCoveredByBoxes) {
  // Columns 0-127 and 128-255 are two boxes' worth. Two spots far above one another in the first.
  b_.state.depth_m(20, 2) = b_.state.depth_m(40, 8) = b_.state.depth_m(100, 60) = 1e-3f;
  b_.state.depth_m(130, 30) = 1e-3f;
  find(1);
  EXPECT_EQ(text(wet_.boxes()), "16-48 x 0-12; 96-112 x 56-64; 128-144 x 28-32; ");
  EXPECT_EQ(wet_.tile_width(), 16);
}

TEST_F(WetCellsTest, AreAllOfTheAwakeOnesIfAsked) {
  put_to_sleep(5);
  find(3);
  wet_.find_all(tiles_);
  EXPECT_EQ(row(3), "0-80 96-256 ");
  EXPECT_EQ(row(16), "0-256 ");
}

TEST_F(WetCellsTest, AreTheSameForAnyThreads) {
  for (int k = 0; k < 64; ++k) b_.state.depth_m((k * 37) % 256, k) = 1e-3f;
  find(2);
  const std::string middle = row(31), boxes = text(wet_.boxes());
  const std::size_t runs = wet_.runs().size();
  for (const bool backwards : {false, true}) {
    WetCells many;
    many.find(tiles_, b_.state.depth_m, 2, backwards ? Threads::backwards() : Threads(7));
    std::swap(many, wet_);
    EXPECT_EQ(row(31), middle);
    EXPECT_EQ(wet_.runs().size(), runs);
    EXPECT_EQ(text(wet_.boxes()), boxes);
  }
}

TEST(CellsLeft, AreThoseOfTheFirstThatTheSecondHasNot) {
  const std::vector<conservative::Run> a{{0, 0, 10}, {0, 20, 30}, {2, 0, 8}, {3, 4, 6}};
  const std::vector<conservative::Run> b{{0, 2, 4}, {0, 6, 24}, {1, 0, 99}, {2, 8, 9}, {3, 0, 9}};
  std::string left;
  for_cells_left(a, b, [&](int y, int x0, int x1) {
    left += std::to_string(y) + ": " + std::to_string(x0) + "-" + std::to_string(x1) + "; ";
  });
  EXPECT_EQ(left, "0: 0-2; 0: 4-6; 0: 24-30; 2: 0-8; ");
}

}  // namespace
}  // namespace pentimento::conservative
