#include "core/detail/store/tile_line.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

// 5 x 3 tiles of 4 x 4 blocks; those of the middle row in columns 0, 1, 3 and 4 have changed.
std::vector<TileRun> runs_along(Axis axis) {
  const DetailLayout layout({20, 12, 1, 1}, 32);
  ChangedBlocks changed(layout);
  for (const int x : {0, 4, 12, 16}) changed.add(4, x, x + 1);
  return runs_of(layout, changed, axis);
}

TEST(TileLine, ATileThatStandsStillEndsARun) {
  const std::vector<TileRun> runs = runs_along(Axis::kX);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].tiles, (std::vector<int>{5, 6}));
  EXPECT_EQ(runs[1].tiles, (std::vector<int>{8, 9}));
  EXPECT_EQ(runs[1].box.x0, 12);
  EXPECT_EQ(runs[1].box.x1, 20);
}

TEST(TileLine, AcrossTheLineEveryTileIsARunOfItsOwn) {
  const std::vector<TileRun> runs = runs_along(Axis::kY);
  ASSERT_EQ(runs.size(), 4u);
  for (const TileRun& run : runs) EXPECT_EQ(run.tiles.size(), 1u);
}

}  // namespace
}  // namespace pentimento
