#include "core/detail/store/changed_blocks.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

const DetailLayout kLayout({100, 90, 1, 1}, 8);  // tiles of 16 blocks, 7 columns

TEST(ChangedBlocks, CutsRowsAtTilesAndAtTheCanvas) {
  ChangedBlocks changed(kLayout);
  changed.add(20, 10, 40);
  changed.add(-1, 0, 5);
  changed.add(3, 97, 120);
  const std::vector<BlockStrip> strips = changed.strips();
  ASSERT_EQ(strips.size(), 4u);
  EXPECT_EQ(strips[0].tile, 6);
  EXPECT_EQ(strips[0].x0, 97);
  EXPECT_EQ(strips[0].x1, 100);
  EXPECT_EQ(strips[1].tile, 7);
  EXPECT_EQ(strips[1].x0, 10);
  EXPECT_EQ(strips[1].x1, 16);
  EXPECT_EQ(strips[3].tile, 9);
  EXPECT_EQ(strips[3].x1, 40);
}

TEST(ChangedBlocks, KeepsOneSpanARowAndForgetsThemAll) {
  ChangedBlocks changed(kLayout);
  changed.add(CellBox{2, 4, 5, 7});
  changed.add(5, 9, 11);
  EXPECT_EQ(changed.strips()[0].x1, 11);
  EXPECT_EQ(changed.strips()[1].x1, 4);
  const CellBox box = changed.box(0);
  EXPECT_EQ(box.x0, 2);
  EXPECT_EQ(box.x1, 11);
  EXPECT_EQ(box.y0, 5);
  EXPECT_EQ(box.y1, 7);
  EXPECT_TRUE(changed.has(0));
  changed.clear();
  EXPECT_TRUE(changed.empty());
  EXPECT_FALSE(changed.has(0));
  EXPECT_TRUE(changed.strips().empty());
}

}  // namespace
}  // namespace pentimento
