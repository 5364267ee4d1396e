#include "core/detail/lock/lock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/detail/store/open_cells.h"
#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

class LockTest : public ::testing::Test {
 protected:
  LockTest() : guide_(make_canvas_state({16, 16, 1, 1}, 1, 1, 3, 1.0f)) {}

  float* depth() { return canvas_.find(0)->depth_m.data(); }
  float* pigment() { return canvas_.find(0)->pigment[0].data(); }
  float at(int x, int y) { return depth()[y * layout_.side() + x]; }
  void lock() {
    canvas_.ensure_planes(0, guide_);
    ChangedBlocks all(layout_);
    all.add({0, 16, 0, 16});
    lock_.lock(canvas_, guide_, all.strips(), Threads(1));
  }
  double off() {
    double most = 0;
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x)
        most = std::max(most, std::abs(test::block_mean(canvas_, WetPlane{}, x, y) -
                                       static_cast<double>(guide_.depth_m(x, y))));
    return most;
  }

  const DetailLayout layout_{{16, 16, 1, 1}, 8};
  CanvasState guide_;
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 1, 1, 3, substrate_, *store_};
  Lock lock_{layout_};
};

TEST_F(LockTest, MakesBlocksHoldWhatTheGuideHolds) {
  for (int y = 4; y < 12; ++y)
    for (int x = 4; x < 12; ++x) guide_.depth_m(x, y) = 0.001f * static_cast<float>(x + y);
  canvas_.ensure_planes(0, guide_);
  for (int y = 30; y < 98; ++y)
    for (int x = 30; x < 98; ++x) depth()[y * layout_.side() + x] = 0.01f;
  lock();
  EXPECT_LT(off(), 1e-8);  // of 0.023: a float's rounding of each cell
  // What lay where the guide has nothing is gone.
  EXPECT_EQ(at(31, 31), 0);
}

TEST_F(LockTest, ShowsNoBlocks) {
  // A slope in the guide, even paint on the detail canvas.
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) guide_.depth_m(x, y) = 0.01f + 0.0005f * static_cast<float>(x);
  canvas_.ensure_planes(0, guide_);
  for (int i = 0; i < 128 * 128; ++i) depth()[i] = 0.01f;
  lock();
  EXPECT_LT(off(), 1e-8);
  // Jumps across block borders are no larger than steps inside: a ratio per block alone would jump
  // by the whole difference of two cells, 5e-4, and be flat inside.
  for (int x = 17; x < 110; ++x) EXPECT_LT(std::abs(at(x + 1, 60) - at(x, 60)), 1.5e-4) << x;
}

TEST_F(LockTest, ShowsNoBlocksWhereTheyAlternate) {
  // Columns of blocks that are to hold a tenth more and less in turn. Interpolated between centres,
  // the ratios themselves change their blocks by half of it; sharpened twice, by seven eighths.
  // What is left jumps at the borders.
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) guide_.depth_m(x, y) = 0.01f * (x % 2 == 0 ? 1.1f : 0.9f);
  canvas_.ensure_planes(0, guide_);
  for (int i = 0; i < 128 * 128; ++i) depth()[i] = 0.01f;
  lock();
  EXPECT_LT(off(), 1e-8);
  for (int x = 31; x < 100; x += 8) {
    const float inside = std::abs(at(x, 60) - at(x - 1, 60));
    const float jump = std::abs(at(x + 1, 60) - at(x, 60)) - inside;
    EXPECT_LT(jump, 0.01f * 0.2f * 0.2f) << x;  // an eighth of 0.2, and some for ratios' products
  }
}

TEST_F(LockTest, FillsWhatIsOwedBesideItsNeighbours) {
  for (int y = 0; y < 16; ++y) guide_.depth_m(7, y) = guide_.depth_m(8, y) = 0.004f;
  canvas_.ensure_planes(0, guide_);
  for (int y = 0; y < 128; ++y)
    for (int x = 56; x < 64; ++x) depth()[y * layout_.side() + x] = 0.004f;
  lock();  // column 8 has none
  EXPECT_LT(off(), 1e-8);
  EXPECT_GT(at(64, 60), 2 * at(70, 60));  // leans on the paint it came from
  EXPECT_GT(lock_.statistics().owed, 0);
}

TEST_F(LockTest, PigmentThatIsOwedLeansOnItsNeighboursToo) {
  for (int y = 0; y < 16; ++y)
    for (int x = 6; x < 10; ++x) {
      guide_.depth_m(x, y) = 0.004f;
      guide_.channel(0, 0)(x, y) = x < 9 ? 0.01f : 0.0f;
    }
  canvas_.ensure_planes(0, guide_);
  DetailTile* tile = canvas_.find(0);
  for (int y = 0; y < 128; ++y)
    for (int x = 48; x < 80; ++x) {
      depth()[y * layout_.side() + x] = 0.004f;
      tile->pigment[0].data()[y * layout_.side() + x] = x < 64 ? 0.01f : 0.0f;
    }
  lock();  // column 8 has depth and no pigment
  const float* pigment = tile->pigment[0].data() + 60 * layout_.side();
  EXPECT_NEAR(test::block_mean(canvas_, WetPlane{0}, 8, 7), 0.01, 1e-8);
  for (int x = 64; x < 71; ++x) EXPECT_GT(pigment[x], pigment[x + 1]);
  EXPECT_GT(pigment[71], 0);
  EXPECT_EQ(pigment[72], 0);
}

TEST_F(LockTest, LeavesOtherBlocksAlone) {
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) guide_.depth_m(x, y) = 0.02f;
  canvas_.ensure_planes(0, guide_);
  for (int i = 0; i < 128 * 128; ++i) depth()[i] = 0.01f;
  ChangedBlocks some(layout_);
  some.add({4, 9, 5, 7});
  lock_.lock(canvas_, guide_, some.strips(), Threads(1));
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const bool inside = x >= 4 && x < 9 && y >= 5 && y < 7;
      EXPECT_NEAR(test::block_mean(canvas_, WetPlane{}, x, y), inside ? 0.02 : 0.01, 1e-8);
    }
  EXPECT_EQ(at(4 * 8 - 1, 45), 0.01f);
}

TEST_F(LockTest, SmoothsRatiosUpToTwoAndKeepsGreaterOnesToTheirBlock) {
  // One block in an even film is to hold `ratio` times what it holds: up to 2 its neighbours take
  // part in the change, beyond they stay as they are but for the rounding of their mean.
  const auto neighbour_changes = [&](float ratio) {
    guide_.depth_m.fill(0.01f);
    guide_.depth_m(8, 8) = ratio * 0.01f;
    canvas_.ensure_planes(0, guide_);
    std::fill_n(depth(), 128 * 128, 0.01f);
    lock();
    EXPECT_LT(off(), 1e-8) << ratio;
    bool changes = false;
    for (int y = 56; y < 80; ++y)
      for (int x = 56; x < 64; ++x) changes |= std::abs(at(x, y) - 0.01f) > 1e-6f;
    return changes;
  };
  EXPECT_TRUE(neighbour_changes(1.9f));
  EXPECT_TRUE(neighbour_changes(1 / 1.9f));
  EXPECT_FALSE(neighbour_changes(2.1f));
  EXPECT_FALSE(neighbour_changes(1 / 2.1f));
}

TEST_F(LockTest, FillsBlocksThatOweMoreThanSixteenTimesWhatTheyHold) {
  const auto owed = [&](float ratio) {
    guide_.depth_m.fill(0.01f);
    canvas_.ensure_planes(0, guide_);
    std::fill_n(depth(), 128 * 128, 0.01f);
    for (int y = 64; y < 72; ++y)
      for (int x = 64; x < 72; ++x) depth()[y * layout_.side() + x] = 0.01f / ratio;
    const std::int64_t before = lock_.statistics().owed;
    lock();
    EXPECT_LT(off(), 1e-8) << ratio;
    return lock_.statistics().owed - before;
  };
  EXPECT_EQ(owed(15.9f), 0);
  EXPECT_EQ(owed(16.1f), 1);
}

TEST_F(LockTest, PigmentIsSmoothedWhereTheDepthIsInOrder) {
  // ShowsNoBlocks for a pigment, in a film that holds what it should.
  guide_.depth_m.fill(0.01f);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      guide_.channel(0, 0)(x, y) = 0.01f + 0.0005f * static_cast<float>(x);
  canvas_.ensure_planes(0, guide_);
  std::fill_n(depth(), 128 * 128, 0.01f);
  std::fill_n(pigment(), 128 * 128, 0.01f);
  lock();
  const float* row = pigment() + 60 * layout_.side();
  for (int x = 17; x < 110; ++x) EXPECT_LT(std::abs(row[x + 1] - row[x]), 1.5e-4) << x;
}

TEST_F(LockTest, FillsPigmentByTheDepthThatItHasJustFilled) {
  // Column 8 has neither. Its pigment is a weight of its own times the depth, so it falls off
  // faster than the depth.
  for (int y = 0; y < 16; ++y)
    for (int x = 7; x < 9; ++x) guide_.depth_m(x, y) = guide_.channel(0, 0)(x, y) = 0.004f;
  canvas_.ensure_planes(0, guide_);
  for (int y = 0; y < 128; ++y)
    for (int x = 56; x < 64; ++x)
      depth()[y * layout_.side() + x] = pigment()[y * layout_.side() + x] = 0.004f;
  lock();
  const float* row = pigment() + 60 * layout_.side();
  EXPECT_GT(row[64] / at(64, 60), 2 * row[69] / at(69, 60));
}

TEST_F(LockTest, CountsBlocksThatAreInOrder) {
  guide_.depth_m.fill(0.0078125f);  // of which a mean is exact
  canvas_.ensure_planes(0, guide_);
  std::fill_n(depth(), 128 * 128, 0.0078125f);
  lock();
  EXPECT_EQ(lock_.statistics().blocks[0], 16 * 16);
  for (std::size_t bin = 1; bin < 8; ++bin) EXPECT_EQ(lock_.statistics().blocks[bin], 0);
}

TEST_F(LockTest, CountsRatiosBeyondAllBounds) {
  guide_.depth_m(3, 3) = 0.01f;
  guide_.depth_m(5, 5) = 0.01f;
  canvas_.ensure_planes(0, guide_);
  for (int y = 24; y < 48; ++y)
    for (int x = 24; x < 48; ++x) depth()[y * layout_.side() + x] = y < 32 ? 0.0049f : 0.0051f;
  lock();
  EXPECT_EQ(lock_.statistics().blocks[7], 1);  // 104 % off
  EXPECT_EQ(lock_.statistics().blocks[6], 1);  // 96 % off
}

TEST_F(LockTest, WhereLayersDoNotCorrespondOnlyTheirSumIsLocked) {
  // Two layers of one pigment. The guide has all of it on top, the detail canvas all of it below.
  CanvasState guide = make_canvas_state({16, 16, 1, 1}, 2, 1, 3, 1.0f);
  for (int x = 4; x < 12; ++x) {
    guide.depth_m(x, 5) = 0.01f;
    guide.channel(1, 0)(x, 5) = 0.03f;
  }
  DetailCanvas canvas(layout_, 2, 1, 3, substrate_, *store_);
  canvas.ensure_planes(0, guide);
  DetailTile& tile = *canvas.find(0);
  ASSERT_TRUE(canvas.make(tile.pigment[0]));
  for (int y = 40; y < 48; ++y)
    for (int x = 32; x < 96; ++x) {
      tile.depth_m.data()[y * layout_.side() + x] = 0.01f;
      tile.pigment[0].data()[y * layout_.side() + x] = 0.02f;
    }
  // In one block of the row the fine cells have not opened the layer yet.
  make_openable(tile.open, layout_);
  tile.open.mismatched[static_cast<std::size_t>(5 * layout_.blocks() + 7)] = 1;
  ChangedBlocks all(layout_);
  all.add({0, 16, 0, 16});
  Lock(layout_).lock(canvas, guide, all.strips(), Threads(1));
  const auto mean = [&](int layer, int x) {
    return test::block_mean(canvas, WetPlane{layer}, x, 5);
  };
  EXPECT_NEAR(mean(0, 7), 0.03, 1e-8);
  EXPECT_EQ(mean(1, 7), 0);
  // Elsewhere each layer is what the guide has of it.
  EXPECT_EQ(mean(0, 9), 0);
  EXPECT_NEAR(mean(1, 9), 0.03, 1e-8);
}

TEST_F(LockTest, TheStateDoesNotDependOnThreads) {
  // Nine tiles, for more strips than one task has.
  const DetailLayout layout({48, 48, 1, 1}, 8);
  CanvasState guide = make_canvas_state({48, 48, 1, 1}, 1, 1, 3, 1.0f);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x) {
      guide.depth_m(x, y) = 0.01f + 0.001f * static_cast<float>((x * 7 + y * 5) % 7);
      guide.channel(0, 0)(x, y) = 0.02f + 0.001f * static_cast<float>((x * 3 + y * 5) % 7);
    }
  const auto locked_by = [&](const Threads& threads) {
    DetailCanvas canvas(layout, 1, 1, 3, substrate_, *store_);
    ChangedBlocks all(layout);
    all.add({0, 48, 0, 48});
    for (const int tile : all.tiles()) {
      canvas.ensure_planes(tile, guide);
      for (int i = 0; i < 128 * 128; ++i) {
        canvas.find(tile)->depth_m.data()[i] = 0.01f + 1e-5f * static_cast<float>(i % 13);
        canvas.find(tile)->pigment[0].data()[i] = 0.02f + 1e-5f * static_cast<float>(i % 17);
      }
    }
    Lock(layout).lock(canvas, guide, all.strips(), threads);
    std::vector<float> values;
    for (const int tile : all.tiles())
      for (const WetPlane plane : {WetPlane{}, WetPlane{0}}) {
        const float* data = plane.of(*canvas.find(tile)).data();
        values.insert(values.end(), data, data + 128 * 128);
      }
    return values;
  };
  const std::vector<float> one = locked_by(Threads(1));
  EXPECT_EQ(locked_by(Threads(2)), one);
  EXPECT_EQ(locked_by(Threads(7)), one);
  EXPECT_EQ(locked_by(Threads::backwards()), one);
}

TEST_F(LockTest, CountsRatios) {
  guide_.depth_m(3, 3) = 0.01f;
  canvas_.ensure_planes(0, guide_);
  for (int y = 24; y < 32; ++y)
    for (int x = 24; x < 32; ++x) depth()[y * layout_.side() + x] = 0.0098f;
  lock();
  EXPECT_EQ(lock_.statistics().blocks[3], 1);  // 2 % off: between 1 and 3 %
}

}  // namespace
}  // namespace pentimento
