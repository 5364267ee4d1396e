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

TEST(AwakeTiles, AreUsedUntilASecondLookAtWhatRests) {
  constexpr CanvasGeometry kLarge = {1024, 1024, 1.024, 1.024};
  const auto most = [&](const std::vector<std::int64_t>& steps, bool dried,
                        std::int64_t settling_steps = 9) {
    AwakeTiles tiles(kLarge);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      // Strokes far from one another, each over 4 x 1 tiles.
      tiles.touch(128, 128 + 256 * static_cast<int>(i), 128, 32, {1, steps[i], settling_steps});
      if (dried) tiles.clear();
    }
    tiles.finish(5000);
    return tiles.most_used_share(64, 64);
  };
  // With 32 cells on either side a stroke comes to 6 x 3 tiles of 32 cells, 4 x 2 of 64.
  constexpr double kStroke = 4.0 * 2 / 256;
  EXPECT_EQ(most({}, false), 0);
  EXPECT_EQ(most({10}, false), kStroke);
  EXPECT_EQ(most({10, 10, 10}, false), 3 * kStroke);
  // A look every 128 steps: what moved within 256 steps may still be held.
  EXPECT_EQ(most({10, 200, 275}, false), 3 * kStroke);  // the first moved until step 19
  EXPECT_EQ(most({10, 200, 276}, false), 2 * kStroke);
  EXPECT_EQ(most({10, 4000, 4001}, false), 2 * kStroke);
  EXPECT_EQ(most({10, 11, 4000}, false), 2 * kStroke);
  EXPECT_EQ(most({10, 4000, 4001}, false, 54), 3 * kStroke);  // thin paint may move all the time
  // Drying ends it; what was used before counts.
  EXPECT_EQ(most({10, 11}, true), kStroke);
}

}  // namespace
}  // namespace pentimento
