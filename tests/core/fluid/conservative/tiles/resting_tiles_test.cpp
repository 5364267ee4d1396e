#include "core/fluid/conservative/tiles/resting_tiles.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/give_back.h"

namespace pentimento::conservative {
namespace {

/// A canvas of 4 by 2 tiles of 8 cells; those in `awake` are.
class ChangingSleep {
 public:
  ChangingSleep()
      : state_(make_canvas_state({30, 16, 0.030, 0.016}, 1, 1, 1, 0)),
        contact_(make_brush_contact(30, 16)),
        tiles_(state_.geometry, 0.008f) {}
  const SleepTiles& with(const std::set<int>& awake) {
    state_.sleep.assign(static_cast<std::size_t>(tiles_.count()) * kSleepValues, 0);
    for (int tile = 0; tile < tiles_.count(); ++tile)
      state_.sleep[static_cast<std::size_t>(tile) * kSleepValues + kAsleep] =
          awake.contains(tile) ? 0.0f : 1.0f;
    const Model model;
    const std::vector<float> amount{1};
    tiles_.wake(state_, {model, {0, 0, 9.81f}, 1.0f / 45, contact_, amount, threads_});
    return tiles_;
  }

 private:
  CanvasState state_;
  BrushContact contact_;
  Threads threads_;
  SleepTiles tiles_;
};

/// What the last of so many looks finds, as x0, x1, y0, y1.
std::vector<std::vector<int>> after(int steps, RestingTiles& resting, const SleepTiles& tiles) {
  std::vector<CellBox> boxes;
  for (int i = 0; i < steps; ++i) {
    EXPECT_TRUE(boxes.empty()) << "only the last look finds any";
    boxes = resting.find(tiles);
  }
  std::vector<std::vector<int>> out;
  for (const CellBox& b : boxes) out.push_back({b.x0, b.x1, b.y0, b.y1});
  return out;
}

TEST(RestingTiles, AreFoundOnceAfterTheyWereAwakeAndAsFarAsSleepGoes) {
  constexpr int kSteps = kStepsBetweenGivingBack;
  using Boxes = std::vector<std::vector<int>>;
  ChangingSleep sleep;
  RestingTiles resting;
  EXPECT_EQ(after(kSteps, resting, sleep.with({0, 2, 5})), Boxes());  // who sleeps never was awake
  // Tile 0 sleeps now, and tile 1 beside it; in the row below it is tiles 4 to 7.
  const Boxes found = {{0, 16, 0, 8}, {0, 30, 8, 16}};
  EXPECT_EQ(after(kSteps, resting, sleep.with({2})), found);
  EXPECT_EQ(after(kSteps, resting, sleep.with({2})), Boxes());
  // The last tile of a row is narrower.
  EXPECT_EQ(after(kSteps, resting, sleep.with({0, 3})), (Boxes{{8, 24, 0, 8}}));
  EXPECT_EQ(after(kSteps, resting, sleep.with({0})), (Boxes{{8, 30, 0, 8}}));
  // Awake for a step in between is awake.
  resting.find(sleep.with({7}));
  EXPECT_EQ(after(kSteps - 1, resting, sleep.with({})), (Boxes{{0, 30, 0, 8}, {0, 30, 8, 16}}));
}

}  // namespace
}  // namespace pentimento::conservative
