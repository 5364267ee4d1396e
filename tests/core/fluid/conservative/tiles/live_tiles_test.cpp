#include "core/fluid/conservative/tiles/live_tiles.h"

#include <gtest/gtest.h>

#include <set>

namespace pentimento::conservative {
namespace {

// A canvas of 8 by 4 tiles of 8 cells; those in `awake` are.
struct Tiles {
  explicit Tiles(const std::set<int>& awake_tiles)
      : state(make_canvas_state({64, 32, 0.064, 0.032}, 1, 1, 1, 0)),
        contact(make_brush_contact(64, 32)),
        tiles(state.geometry, 0.008f) {
    state.sleep.assign(static_cast<std::size_t>(tiles.count()) * kSleepValues, 0);
    for (int tile = 0; tile < tiles.count(); ++tile)
      state.sleep[static_cast<std::size_t>(tile) * kSleepValues + kAsleep] =
          awake_tiles.count(tile) == 0 ? 1.0f : 0.0f;
    const Model model;
    const std::vector<float> amount{1};
    tiles.wake(state, {model, {0, 0, 9.81f}, 1.0f / 45, contact, amount, pool});
  }
  std::set<int> find(LiveTiles& live, const std::set<int>& stirring) const {
    live.find(tiles, pool, [&](int tile) { return stirring.count(tile) != 0; });
    std::set<int> found;
    for (const auto& r : live.live_of(tiles.runs(), tiles))
      for (int x = r.x0; x < r.x1; ++x) found.insert(r.y / 8 * 8 + x / 8);
    return found;
  }
  CanvasState state;
  BrushContact contact;
  Threads pool;
  SleepTiles tiles;
};

TEST(LiveTiles, SpreadOverSidesOfAwakeTiles) {
  // A row of three, one that touches it by a corner, and a column elsewhere.
  const Tiles canvas({0, 1, 2, 11, 5, 13, 21});
  ASSERT_EQ(canvas.tiles.awake_tiles().size(), 7u);
  LiveTiles live;
  EXPECT_EQ(canvas.find(live, {2}), (std::set<int>{0, 1, 2}));
  EXPECT_EQ(canvas.find(live, {11}), (std::set<int>{11}));
  EXPECT_EQ(canvas.find(live, {13}), (std::set<int>{5, 13, 21}));
  EXPECT_EQ(canvas.find(live, {0, 5}), (std::set<int>{0, 1, 2, 5, 13, 21}));
}

TEST(LiveTiles, AreTheSameForAnyThreads) {
  std::set<int> awake;
  for (int tile = 0; tile < 32; ++tile) awake.insert(tile);
  const Tiles canvas(awake);
  LiveTiles one, many;
  canvas.find(one, {17});
  many.find(canvas.tiles, Threads(7), [](int tile) { return tile == 17; });
  const auto& all = canvas.tiles.runs();
  EXPECT_EQ(one.live_of(all, canvas.tiles).size(), 32u) << "one run for each row of cells";
  EXPECT_EQ(many.live_of(all, canvas.tiles).size(), 32u);
}

}  // namespace
}  // namespace pentimento::conservative
