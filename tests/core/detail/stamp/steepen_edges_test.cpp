#include "core/detail/stamp/steepen_edges.h"

#include <gtest/gtest.h>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

constexpr int kFactor = 8;

/// Paint below row 6, whose upper side rises over one block; its guide holds what the blocks hold.
class SteepenEdgesTest : public ::testing::Test {
 protected:
  SteepenEdgesTest() {
    DetailTile& tile = canvas_.at(0);
    canvas_.make(tile.depth_m);
    canvas_.make(tile.pigment[0]);
    for (int y = 0; y < side(); ++y) {
      const float rise = (static_cast<float>(y) - 44) / 12;  // from block 5.5 to block 7
      const float depth = 1e-3f * std::clamp(rise, 0.0f, 1.0f);
      for (int x = 0; x < side(); ++x) cell(WetPlane{}, x, y) = depth;
      for (int x = 0; x < side(); ++x)
        cell(WetPlane{0}, x, y) = depth * (1 + 0.5f * static_cast<float>(x % 3));
    }
    for (int y = 0; y < layout_.blocks(); ++y)
      for (int x = 0; x < layout_.blocks(); ++x)
        guide_.depth_m(x, y) = static_cast<float>(mean(WetPlane{}, x, y));
  }
  int side() const { return layout_.side(); }
  float& cell(const WetPlane& q, int x, int y) {
    return q.of(*canvas_.find(0)).data()[static_cast<std::ptrdiff_t>(y) * side() + x];
  }
  double mean(const WetPlane& q, int x, int y) {
    double sum = 0;
    for (int j = 0; j < kFactor; ++j)
      for (int i = 0; i < kFactor; ++i)
        sum += static_cast<double>(cell(q, x * kFactor + i, y * kFactor + j));
    return sum / (kFactor * kFactor);
  }
  /// All blocks, left by a brush that went along `way`.
  void gather(Vec2f way) {
    std::vector<ReleasedBlock> blocks;
    for (int y = 0; y < layout_.blocks(); ++y)
      for (int x = 0; x < layout_.blocks(); ++x) blocks.push_back({{0, y, x, x + 1}, way});
    steepen_edges(canvas_, guide_, blocks, Threads(2));
  }

  const DetailLayout layout_{{16, 16, 0.016, 0.016}, kFactor};
  CanvasState guide_ = make_canvas_state({16, 16, 0.016, 0.016}, 1, 1, 3, 0.9f);
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 1, 1, 3, substrate_, *store_};
};

TEST_F(SteepenEdgesTest, DrawsTheFringeIntoTheBodyAndKeepsEachBlock) {
  const double fringe = static_cast<double>(cell(WetPlane{}, 40, 45));
  std::vector<double> before;
  for (int p = -1; p < 1; ++p)
    for (int y = 0; y < 16; ++y) before.push_back(mean(WetPlane{p}, 5, y));
  gather({1, 0});
  EXPECT_LT(static_cast<double>(cell(WetPlane{}, 40, 45)), 0.4 * fringe);
  std::size_t i = 0;
  for (int p = -1; p < 1; ++p)
    for (int y = 0; y < 16; ++y, ++i)
      // A float's rounding of the ratio and of each cell.
      EXPECT_NEAR(mean(WetPlane{p}, 5, y), before[i], 5e-7 * before[i]) << p << ", " << y;
}

TEST_F(SteepenEdgesTest, LeavesTheBodyAndBareCanvasAsTheyAre) {
  gather({1, 0});
  for (int x = 0; x < side(); ++x) {
    EXPECT_EQ(cell(WetPlane{}, x, 43), 0) << x;
    EXPECT_EQ(cell(WetPlane{}, x, 64), 1e-3f) << x;
  }
}

TEST_F(SteepenEdgesTest, LeavesTheEndOfAStrokeAsItIs) {
  std::vector<float> before;
  for (int y = 0; y < side(); ++y) before.push_back(cell(WetPlane{}, 40, y));
  gather({0, 1});
  for (int y = 0; y < side(); ++y)
    EXPECT_EQ(cell(WetPlane{}, 40, y), before[static_cast<std::size_t>(y)]) << y;
}

TEST_F(SteepenEdgesTest, LeavesPaintThatThinsOutSlowlyAsItIs) {
  for (int y = 0; y < layout_.blocks(); ++y)
    for (int x = 0; x < layout_.blocks(); ++x) {
      const float depth = 1e-4f * static_cast<float>(y);  // a tenth of its depth per block
      guide_.depth_m(x, y) = depth;
      for (int j = 0; j < kFactor; ++j)
        for (int i = 0; i < kFactor; ++i)
          cell(WetPlane{}, x * kFactor + i, y * kFactor + j) = depth * (i == 0 ? 0.1f : 1.0f);
    }
  gather({1, 0});
  for (int y = 11; y < layout_.blocks(); ++y)
    EXPECT_EQ(cell(WetPlane{}, 40, y * kFactor), 1e-4f * static_cast<float>(y) * 0.1f) << y;
}

}  // namespace
}  // namespace pentimento
