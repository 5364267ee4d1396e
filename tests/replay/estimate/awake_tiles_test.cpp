#include "replay/estimate/awake_tiles.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

constexpr CanvasGeometry kGrid = {100, 70, 0.1, 0.07};  // 4 x 3 tiles of 32 cells a side
constexpr double kTile = 32 * 32;

TEST(AwakeTiles, MoveForAWhileAfterTheLastTouch) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {1, 10, 9});
  tiles.touch(6, 6, {1, 14, 9});  // the same tile, 4 steps later
  tiles.finish(1000);
  EXPECT_EQ(tiles.awake().cell_steps, (4 + 9) * kTile);
  EXPECT_EQ(tiles.tilted_cell_steps(), 0);
}

TEST(AwakeTiles, NoLongerThanTheSession) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {1, 10, 9});
  tiles.finish(13);
  EXPECT_EQ(tiles.awake().cell_steps, 3 * kTile);
}

TEST(AwakeTiles, ABoxTouchesEveryTileUnderItOnce) {
  AwakeTiles tiles(kGrid);
  tiles.touch(31, 40, 2, 30, {1, 0, 9});  // x 31 and 32, y 40 to 69: 2 x 2 tiles
  tiles.finish(100);
  EXPECT_EQ(tiles.awake().cell_steps, 4 * 9 * kTile);
}

TEST(AwakeTiles, CountChannelsOfAllThePaintThatMixes) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {0b001, 0, 9});
  tiles.touch(5, 5, {0b110, 4, 9});
  tiles.finish(100);
  EXPECT_EQ(tiles.awake().cell_steps, (4 + 9) * kTile);
  EXPECT_EQ(tiles.awake().channel_steps, (4 * 1 + 9 * 3) * kTile);
}

TEST(AwakeTiles, AllWetTilesMoveWhileTilted) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {1, 0, 9});
  tiles.touch(50, 50, {1, 0, 9});
  tiles.tilt(1, 20);
  tiles.tilt(0.1, 70);  // too little to move anything
  tiles.finish(100);
  EXPECT_EQ(tiles.tilted_cell_steps(), 2 * 50 * kTile);
}

TEST(AwakeTiles, DryPaintStays) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {1, 0, 9});
  tiles.clear();
  tiles.tilt(1, 20);
  tiles.finish(100);
  EXPECT_EQ(tiles.awake().cell_steps, 0);
  EXPECT_EQ(tiles.tilted_cell_steps(), 0);
}

TEST(AwakeTiles, PaintReachesTheSleepTilesWithin32CellsOfIt) {
  AwakeTiles tiles(kGrid);
  tiles.touch(5, 5, {1, 0, 9});
  tiles.clear();                                              // what dried has been wet
  EXPECT_EQ(tiles.reached_share(16, 16), 4.0 * 4 / (7 * 5));  // cells 0 to 63 each way
  EXPECT_EQ(tiles.reached_share(64, 128), 1.0 / 2);
  tiles.touch(99, 69, {1, 0, 9});  // the tile of x 96 and y 64 on
  EXPECT_EQ(tiles.reached_share(16, 16), (4.0 * 4 + 3 * 3) / (7 * 5));
  EXPECT_EQ(tiles.reached_share(64, 128), 1.0);
}

TEST(SettlingSteps, ThinPaintMovesLongerTheMoreOfItThereIs) {
  BrushSettings thick, thin, much;
  thick.pigment_frac = 0.8f;
  thin.pigment_frac = much.pigment_frac = 0.1f;
  thin.medium_frac = 0.2f;
  much.medium_frac = 1;
  EXPECT_LT(settling_steps(thick), settling_steps(thin));
  EXPECT_LT(settling_steps(thin), settling_steps(much));
}

}  // namespace
}  // namespace pentimento
