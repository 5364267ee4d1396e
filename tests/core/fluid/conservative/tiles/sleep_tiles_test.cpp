#include "core/fluid/conservative/tiles/sleep_tiles.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/base/threads.h"
#include "core/fluid/brush_contact.h"
#include "core/model/model.h"

namespace pentimento::conservative {
namespace {

/// 64 x 32 cells of 1 x 2 mm: 4 x 4 tiles of 16 x 8 cells, all asleep under a tilted gravity.
class TilesTest : public ::testing::Test {
 protected:
  TilesTest() {
    state_.sleep.resize(static_cast<std::size_t>(tiles_.count()) * kSleepValues);
    for (int tile = 0; tile < tiles_.count(); ++tile) {
      memory(tile, kAsleep) = 1;
      memory(tile, kGravityX) = kGravity.x;
      memory(tile, kGravityY) = kGravity.y;
      memory(tile, kGravityZ) = kGravity.z;
      memory(tile, kFeelsGravity) = 1;
    }
  }

  float& memory(int tile, SleepValue value) {
    return state_
        .sleep[static_cast<std::size_t>(tile) * kSleepValues + static_cast<std::size_t>(value)];
  }

  StepInput input(Vec3f gravity_m_s2 = kGravity) {
    return {model_, gravity_m_s2, 0.02f, contact_, amount_, threads_};
  }

  void wake(Vec3f gravity_m_s2 = kGravity) { tiles_.wake(state_, input(gravity_m_s2)); }

  /// Row by row: # awake, . asleep.
  std::string awake() const {
    std::string picture;
    for (int row = 0; row < tiles_.rows(); ++row) {
      for (int column = 0; column < tiles_.columns(); ++column)
        picture += tiles_.awake(column, row) ? '#' : '.';
      picture += ' ';
    }
    return picture;
  }

  static constexpr Vec3f kGravity{1, -5, 8};
  CanvasGeometry geometry_{64, 32, 0.064, 0.064};
  Model model_;
  CanvasState state_ = make_canvas_state(geometry_, 1, 1, 3, 1);
  BrushContact contact_ = make_brush_contact(64, 32);
  std::vector<float> amount_ = {1};
  Threads threads_{1};
  SleepTiles tiles_{geometry_, 0.016f};
};

TEST_F(TilesTest, AreAsWideAndAsHighAsFits) {
  EXPECT_EQ(tiles_.tile_width(), 16);
  EXPECT_EQ(tiles_.tile_height(), 8);
  EXPECT_EQ(tiles_.columns(), 4);
  EXPECT_EQ(tiles_.rows(), 4);
}

TEST_F(TilesTest, SleepOnUndisturbed) {
  wake();
  EXPECT_EQ(awake(), ".... .... .... .... ");
}

TEST_F(TilesTest, MotionWithinThreeCellsOfABorderWakesTheTileBeyond) {
  memory(0, kAsleep) = 0;
  state_.velocity_x_m_s(15, 3) = 1e-6f;  // between the cells 15 and 16
  wake();
  EXPECT_EQ(awake(), "##.. .... .... .... ");
}

TEST_F(TilesTest, MotionThroughTheLeftBorderIsTheTilesOwn) {
  memory(1, kAsleep) = 0;
  state_.velocity_x_m_s(15, 3) = 1e-6f;
  wake();
  EXPECT_EQ(awake(), "##.. .... .... .... ");
}

TEST_F(TilesTest, MotionReachesAsFarAsPaintComesInAStep) {
  memory(0, kAsleep) = 0;
  state_.velocity_y_m_s(4, 2) = 1.01f;  // 20.2 mm a step: eleven cells of 2 mm, and two more
  wake();
  // The cells 2 and 3 and thirteen below them: down to 16, the first of the third row of tiles.
  EXPECT_EQ(awake(), "#... #... #... .... ");
  EXPECT_FLOAT_EQ(tiles_.travel_cells(), 10.1f);
}

TEST_F(TilesTest, AnyComponentOfGravityWakesAll) {
  const float enough = model_.wake_gravity_m_s2 * 1.001f;
  for (const Vec3f g :
       {Vec3f{1 + enough, -5, 8}, Vec3f{1, -5 - enough, 8}, Vec3f{1, -5, 8 + enough}}) {
    wake(g);
    EXPECT_EQ(awake(), "#### #### #### #### ");
  }
  memory(5, kFeelsGravity) = 0;
  wake({1, -5, 8 + enough});
  EXPECT_EQ(awake(), "#### #.## #### #### ");
}

TEST_F(TilesTest, ATouchedTileStaysAwakeForTheNextStep) {
  contact_.weight(20, 19) = 1;
  contact_.touch(20, 21, 19, 20);
  wake();
  EXPECT_EQ(awake(), ".... .... .#.. .... ");
  const auto feels = [](const CellBox&) { return true; };
  tiles_.fall_asleep(state_, input(), feels);
  EXPECT_EQ(memory(9, kAsleep), 0);
  clear(contact_);
  wake();
  EXPECT_EQ(awake(), ".... .... .#.. .... ");
  tiles_.fall_asleep(state_, input(), feels);
  EXPECT_EQ(memory(9, kAsleep), 1);
}

TEST_F(TilesTest, RunsAndStripsCoverTheAwakeAndNoMore) {
  for (const int tile : {0, 1, 3, 8}) memory(tile, kAsleep) = 0;
  wake();
  int cells = 0;
  for (const auto& r : tiles_.runs()) cells += r.size();
  EXPECT_EQ(cells, 4 * 16 * 8);
  EXPECT_EQ(tiles_.runs().front().x1, 32);  // neighbours in one run
  ASSERT_EQ(tiles_.strips().size(), 4u);
  cells = 0;
  for (const CellBox& s : tiles_.strips()) cells += (s.x1 - s.x0) * (s.y1 - s.y0);
  EXPECT_EQ(cells, 4 * 16 * 8);
}

}  // namespace
}  // namespace pentimento::conservative
