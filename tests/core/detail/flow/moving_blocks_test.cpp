#include "core/detail/flow/moving_blocks.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(AddMoving, FindsTheCellsBesideMovingEdgesAndThreeAround) {
  const CanvasGeometry guide{200, 50, 1, 1};
  PaintEdges edges(guide, 1);
  edges.x[1](100, 20) = 0.1f;  // between cells 100 and 101
  edges.y[0](30, 40) = -0.1f;  // between rows 40 and 41
  std::vector<conservative::Run> runs;
  for (int y = 0; y < 50; ++y) runs.push_back({y, 0, 200});
  ChangedBlocks blocks(DetailLayout(guide, 1));  // one tile for 128 cells
  add_moving(edges, runs, blocks);
  const CellBox left = blocks.box(0);
  EXPECT_EQ(left.y0, 17);
  EXPECT_EQ(left.y1, 45);
  EXPECT_EQ(left.x0, 27);
  EXPECT_EQ(left.x1, 105);
  for (const BlockStrip& strip : blocks.strips()) {
    EXPECT_EQ(strip.x0, strip.y < 30 ? 97 : 27);
    EXPECT_EQ(strip.x1, strip.y < 30 ? 105 : 34);
  }
  EXPECT_EQ(blocks.strips().size(), 7u + 8u);
}

TEST(AddMoving, LooksOnlyAtTheRuns) {
  const CanvasGeometry guide{64, 8, 1, 1};
  PaintEdges edges(guide, 1);
  edges.x[0](5, 3) = 1;
  ChangedBlocks blocks(DetailLayout(guide, 1));
  add_moving(edges, {{3, 6, 64}, {4, 0, 64}}, blocks);
  EXPECT_TRUE(blocks.empty());
}

}  // namespace
}  // namespace pentimento
