#include <gtest/gtest.h>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

// A blob of paint 40 cells wide in the middle of a canvas of 8 x 6 tiles.
Basin blob(float depth_m, float theta_per_m) {
  Basin b({256, 192, 0.25, 0.1875});
  for (int y = 76; y < 116; ++y)
    for (int x = 108; x < 148; ++x) {
      b.state.depth_m(x, y) = depth_m;
      b.state.channel(0, 0)(x, y) = depth_m * theta_per_m;
    }
  return b;
}

int steps_until_asleep(Basin& b, int most) {
  for (int i = 0; i < most; ++i)
    if (!b.step()) return i;
  return most;
}

TEST(Sleep, ABareCanvasCostsOneStep) {
  Basin b({256, 192, 0.25, 0.1875});
  EXPECT_TRUE(b.step());
  EXPECT_FALSE(b.step());
}

TEST(Sleep, ThickPaintOnATiltedCanvasRestsAtOnce) {
  Basin b = blob(0.01f, 28);  // Phi = 1
  b.gravity_m_s2 = {3, -6, 7};
  EXPECT_LE(steps_until_asleep(b, 100), 3);
  EXPECT_EQ(b.state.depth_m(108, 76), b.state.depth_m(147, 115));
}

TEST(Sleep, ModeratelyThickPaintRestsWithinTwoSeconds) {
  Basin b = blob(0.006f, 13);
  EXPECT_LE(steps_until_asleep(b, 200), 90);
}

TEST(Sleep, NothingIsAwakeAMinuteAfterTheLastTouchOnALevelCanvas) {
  for (const float depth_m : {0.001f, 0.003f, 0.01f}) {
    Basin b = blob(depth_m, 2);
    EXPECT_LT(steps_until_asleep(b, 60 * 45), 60 * 45) << depth_m;
  }
}

TEST(Sleep, ThinPaintRunsUnderTiltAndStopsWhenItThinsOut) {
  Basin b = blob(0.002f, 2);
  b.gravity_m_s2 = {0, -6.9f, 6.9f};
  b.steps(45);
  EXPECT_GT(highest(b.state.velocity_y_m_s), 1e-3f);
  EXPECT_LT(steps_until_asleep(b, 60 * 45), 60 * 45);
  float lowest_wet = 0;  // how far it ran down
  for (int y = 0; y < 192; ++y)
    if (b.state.depth_m(128, y) > 1e-5f) lowest_wet = static_cast<float>(y);
  EXPECT_GT(lowest_wet, 116 + 5);
}

std::vector<int> awake_tiles(const Basin& b) {
  std::vector<int> awake;
  for (std::size_t tile = 0; tile < b.state.sleep.size() / kSleepValues; ++tile)
    if (b.state.sleep[tile * kSleepValues + kAsleep] == 0) awake.push_back(static_cast<int>(tile));
  return awake;
}

TEST(Sleep, WhatRestsStaysSoBesideTilesThatSleep) {
  // A puddle whose round edges lie across the borders of tiles of 16 cells. Woken one by one, its
  // tiles find the forces that they fell asleep with, to a thirtieth of the usual threshold.
  Basin b({64, 64, 0.064, 0.064});
  b.model.velocity_threshold_m_s = 1e-5f;
  b.fill_depth([](int x, int y) { return x > 14 && x < 49 && y > 14 && y < 49 ? 0.0008f : 0.0f; });
  ASSERT_LT(steps_until_asleep(b, 45 * 120), 45 * 120);
  const std::vector<float> asleep = b.state.sleep;
  b.model.velocity_threshold_m_s = 3e-5f;  // the solve of a tile alone differs a little
  for (std::size_t tile = 0; tile < 16; ++tile) {
    b.state.sleep = asleep;
    b.state.sleep[tile * kSleepValues + kAsleep] = 0;
    b.step();
    EXPECT_EQ(highest(b.state.velocity_x_m_s), 0) << tile;
    EXPECT_EQ(lowest(b.state.velocity_x_m_s), 0) << tile;
    EXPECT_EQ(highest(b.state.velocity_y_m_s), 0) << tile;
    EXPECT_EQ(lowest(b.state.velocity_y_m_s), 0) << tile;
  }
}

TEST(Sleep, AStampWakesOnlyWhatItTouches) {
  Basin b = blob(0.01f, 28);
  steps_until_asleep(b, 10);
  // In tile 6 of row 4, each of 32 x 32 cells and 8 of them in a row.
  b.contact.weight(210, 150) = 1;
  b.contact.touch(210, 211, 150, 151);
  EXPECT_TRUE(b.step());
  EXPECT_EQ(awake_tiles(b), (std::vector<int>{4 * 8 + 6}));
  EXPECT_TRUE(b.step());  // found at rest
  EXPECT_EQ(awake_tiles(b), (std::vector<int>{}));
  EXPECT_FALSE(b.step());
}

/// A bare canvas of 16 x 12 tiles with a dab in tile 12 of row 9, pushed by three cells and a part.
Basin dab_far_from_the_corner() {
  Basin b({512, 384, 0.5, 0.375});
  for (int y = 300; y < 312; ++y)
    for (int x = 395; x < 407; ++x) {
      b.state.depth_m(x, y) = 0.0011f + 1e-5f * static_cast<float>(x % 5 + y % 3);
      b.state.channel(0, 0)(x, y) = 0.3f * b.state.depth_m(x, y);
      b.contact.weight(x, y) = 1;
      b.contact.push_x_m(x, y) = 0.0033f + 1e-5f * static_cast<float>(y % 7);
      b.contact.push_y_m(x, y) = -0.0037f + 1e-5f * static_cast<float>(x % 7);
    }
  b.contact.touch(395, 407, 300, 312);
  return b;
}

TEST(Sleep, AFreshCanvasIsComputedOnlyWhereTheBrushTouchedIt) {
  Basin b = dab_far_from_the_corner();
  b.fresh = true;
  EXPECT_TRUE(b.step());
  EXPECT_LE(b.statistic("awake_share_max"), 4.0 / (16 * 12));
}

TEST(Sleep, AFreshCanvasComesToTheSameBitsAsOneComputedEverywhere) {
  Basin all = dab_far_from_the_corner();
  Basin touched = dab_far_from_the_corner();
  touched.fresh = true;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(all.step(), touched.step());
    EXPECT_TRUE(same_bits(all.state.depth_m, touched.state.depth_m)) << i;
    EXPECT_TRUE(same_bits(all.state.channel(0, 0), touched.state.channel(0, 0))) << i;
    EXPECT_TRUE(same_bits(all.state.velocity_x_m_s, touched.state.velocity_x_m_s)) << i;
    EXPECT_TRUE(same_bits(all.state.velocity_y_m_s, touched.state.velocity_y_m_s)) << i;
    EXPECT_EQ(all.state.sleep, touched.state.sleep) << i;
  }
}

/// A bare canvas of cells of 1 mm by 2 mm, asleep, in 8 x 8 tiles of 16 x 8 cells.
class WakeTest : public ::testing::Test {
 protected:
  WakeTest() : b_({128, 64, 0.128, 0.128}) {
    b_.model.sleep_tile_m = 0.016f;
    b_.steps(2);
  }
  static int at(int column, int row) { return row * 8 + column; }
  std::vector<int> wake() {
    SleepTiles tiles(b_.state.geometry, b_.model.sleep_tile_m);
    tiles.wake(b_.state, {b_.model, b_.gravity_m_s2, b_.dt_s, b_.contact, b_.amount, b_.pool});
    clear(b_.contact);
    return tiles.awake_tiles();
  }
  std::vector<int> wake_by_stamp(int x, int y, float push_x_m, float push_y_m) {
    b_.contact.weight(x, y) = 1;
    b_.contact.push_x_m(x, y) = push_x_m;
    b_.contact.push_y_m(x, y) = push_y_m;
    b_.contact.touch(x, x + 1, y, y + 1);
    return wake();
  }

  Basin b_;
};
using List = std::vector<int>;

// Tile (2, 3) is that of columns 32 to 47 and rows 24 to 31. Cell x and its next one to the right
// (below) count, and three cells more on each side.
TEST_F(WakeTest, AStampReachesThreeCells) {
  EXPECT_EQ(wake(), List{});
  EXPECT_EQ(wake_by_stamp(35, 27, 0, 0), (List{at(2, 3)}));
  EXPECT_EQ(wake_by_stamp(34, 27, 0, 0), (List{at(1, 3), at(2, 3)}));
  EXPECT_EQ(wake_by_stamp(43, 27, 0, 0), (List{at(2, 3)}));
  EXPECT_EQ(wake_by_stamp(44, 27, 0, 0), (List{at(2, 3), at(3, 3)}));
  EXPECT_EQ(wake_by_stamp(40, 26, 0, 0), (List{at(2, 2), at(2, 3)}));
  EXPECT_EQ(wake_by_stamp(40, 28, 0, 0), (List{at(2, 3), at(2, 4)}));
}

TEST_F(WakeTest, APushReachesAsFarAsItPushes) {
  // 8.5 mm are 8 cells along x, 9 mm are 4 along y, and three more.
  EXPECT_EQ(wake_by_stamp(40, 27, 0.0005f, 0), (List{at(2, 3)}));
  EXPECT_EQ(wake_by_stamp(40, 27, -0.0085f, 0), (List{at(1, 3), at(2, 3), at(3, 3)}));
  EXPECT_EQ(wake_by_stamp(40, 30, 0, 0.009f), (List{at(2, 2), at(2, 3), at(2, 4)}));
}

TEST_F(WakeTest, PaintThatMovesReachesAsFarAsItComesInAStep) {
  b_.state.sleep[static_cast<std::size_t>(at(2, 3)) * kSleepValues + kAsleep] = 0;
  b_.state.velocity_y_m_s(40, 30) = 0.009f / b_.dt_s;  // 4.5 cells
  EXPECT_EQ(wake(), (List{at(2, 2), at(2, 3), at(2, 4)}));
  b_.state.velocity_y_m_s(40, 30) = 0;
  b_.state.velocity_x_m_s(40, 27) = 0.0085f / b_.dt_s;  // 8.5 cells
  EXPECT_EQ(wake(), (List{at(1, 3), at(2, 3), at(3, 3)}));
}

TEST(Sleep, GravityWakesPaintThatFeelsIt) {
  Basin thin = blob(0.002f, 2);
  steps_until_asleep(thin, 2000);
  thin.gravity_m_s2.x += 0.04f;  // a trembling hand
  EXPECT_FALSE(thin.step());
  thin.gravity_m_s2.x += 4;
  EXPECT_TRUE(thin.step());
  Basin stiff = blob(0.01f, 28);
  steps_until_asleep(stiff, 10);
  stiff.gravity_m_s2.x += 4;
  EXPECT_FALSE(stiff.step());
}

TEST(Sleep, IsPartOfTheStateSoAResumedCanvasGoesOnAlike) {
  Basin a = blob(0.002f, 2);
  a.gravity_m_s2 = {0, -6.9f, 6.9f};
  a.steps(40);
  Basin b({256, 192, 0.25, 0.1875});
  b.gravity_m_s2 = a.gravity_m_s2;
  b.state.depth_m = a.state.depth_m.clone();
  b.state.channel(0, 0) = a.state.channel(0, 0).clone();
  b.state.velocity_x_m_s = a.state.velocity_x_m_s.clone();
  b.state.velocity_y_m_s = a.state.velocity_y_m_s.clone();
  b.state.sleep = a.state.sleep;
  b.state.step = a.state.step;
  a.steps(40);
  b.steps(40);
  EXPECT_TRUE(same_bits(a.state.depth_m, b.state.depth_m));
  EXPECT_TRUE(same_bits(a.state.velocity_y_m_s, b.state.velocity_y_m_s));
}

}  // namespace
}  // namespace pentimento::conservative
