#include "core/detail/flow/moving_parts.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

// A guide of 16 x 16 cells in one tile; each cell is 4 x 4 fine cells.
class MovingPartsTest : public ::testing::Test {
 protected:
  TileRun run(Axis axis) const { return {axis, {0}, {0, 16, 0, 16}}; }
  float& edge(Axis axis, int along, int across) {
    return axis == Axis::kX ? edges_.x[0](along, across) : edges_.y[0](across, along);
  }

  const DetailLayout layout_{{16, 16, 1, 1}, 4};
  PaintEdges edges_{{16, 16, 1, 1}, 1};
  MovingParts parts_{layout_, edges_};
};

TEST_F(MovingPartsTest, LieBetweenEdgesThatStandStill) {
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    for (const int along : {3, 4, 5}) edge(axis, along, 1) = 0.25f;
    edge(axis, 9, 1) = -0.125f;
    // The first two lines lie before the centre of row 0, where nothing moves.
    parts_.find(run(axis), 0, 8);
    ASSERT_EQ(parts_.parts().size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
      const MovingPart& part = parts_.parts()[i];
      EXPECT_EQ(part.line, 2 + static_cast<int>(i) / 2);
      EXPECT_EQ(part.begin, i % 2 == 0 ? 12 : 36);
      EXPECT_EQ(part.cells, i % 2 == 0 ? 16 : 8);
    }
    std::vector<std::uint8_t> expected(16, 0);
    for (const std::size_t block : {3u, 4u, 5u, 6u, 9u, 10u}) expected[block] = 1;
    EXPECT_EQ(parts_.moves(), expected);
  }
}

TEST_F(MovingPartsTest, MoveAsFarAsTheRowsAroundThem) {
  // An edge between two rows moves by what lies between their moves: here by nearly two fine cells.
  // What comes to lie at the edge was as far before it.
  for (const int along : {4, 5, 6, 7, 8, 9}) {
    edge(Axis::kX, along, 1) = 0.375f;
    edge(Axis::kX, along, 2) = 0.6875f;
  }
  parts_.find(run(Axis::kX), 7, 1);  // 3/8 of the way: 0.375 + 0.375 * 0.3125 = 0.4921875
  ASSERT_EQ(parts_.parts().size(), 1u);
  const MovingPart& part = parts_.parts()[0];
  EXPECT_EQ(part.begin, 16);
  const int edge_of_block_7 = 4 * 8 - part.begin;
  const auto at = static_cast<std::size_t>(edge_of_block_7);
  EXPECT_EQ(part.sources.cell[at], edge_of_block_7 - 2);
  EXPECT_FLOAT_EQ(part.sources.share[at], 2 - 4 * 0.4921875f);
}

TEST_F(MovingPartsTest, AreForgottenAtTheNextCall) {
  edge(Axis::kY, 3, 8) = 0.25f;
  parts_.find(run(Axis::kY), 32, 4);
  EXPECT_EQ(parts_.parts().size(), 4u);
  edge(Axis::kY, 3, 8) = 0;
  parts_.find(run(Axis::kY), 32, 4);
  EXPECT_TRUE(parts_.parts().empty());
  EXPECT_EQ(parts_.moves(), std::vector<std::uint8_t>(16, 0));
}

}  // namespace
}  // namespace pentimento
