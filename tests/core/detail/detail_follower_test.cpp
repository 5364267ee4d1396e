#include "core/detail/detail_follower.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/fluid/brush_contact.h"
#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

// A block's mean is scaled by the last float ratio: each of the k k cells is rounded once, 6e-8.
constexpr double kExact = 5e-7;

void expect_reduces_to_guide(test::Painted& painted) {
  const CanvasState& guide = painted.sim().state();
  for (int c = -1; c < guide.channels; ++c) {
    const test::Difference d = test::reduced_difference(painted.follower().canvas(), guide, c);
    EXPECT_LT(d.relative_l2, kExact) << "channel " << c;
    EXPECT_LT(d.worst_block, 10 * kExact) << "channel " << c;  // a thin cell beside thick ones
  }
}

TEST(DetailFollower, ReducesToTheGuide) {
  for (const int factor : {1, 2, 3, 8}) {
    test::Painted painted(128, factor);
    painted.cross();
    expect_reduces_to_guide(painted);
  }
}

TEST(DetailFollower, ReducesToTheGuideWherePaintRuns) {
  test::Painted painted(128, 2);
  BrushSettings thin;
  thin.medium_frac = 1.0f;
  thin.pigment_frac = 0.05f;
  painted.sim().set_settings(thin);
  painted.sim().set_gravity({2, 9, 3});
  painted.cross();
  for (int i = 0; i < 20; ++i) painted.sim().step();
  expect_reduces_to_guide(painted);
}

// What the lock has to put right: mostly that the guide's cells level and move as one. At most 5 %
// of the depth and 10 % of a pigment in thick paint. A prototype of the poster came to 35 to 40 dB
// in thick paint and 28 to 33 dB in glazes: this one is to be closer, beyond the better half of the
// former and the best of the latter. Measured: 39.4 to 48.4 dB, in glazes 34.6 to 38.9 dB.
void expect_near_the_guide(test::Painted& painted, double psnr_db) {
  painted.cross();
  const CanvasState& guide = painted.sim().state();
  for (int c = -1; c < guide.channels; ++c)
    EXPECT_GT(test::reduced_difference(painted.follower().canvas(), guide, c).psnr_db, psnr_db)
        << "channel " << c;
}

TEST(DetailFollower, IsNearTheGuideEvenUnlocked) {
  test::Painted painted(128, 4, 1, false);
  expect_near_the_guide(painted, 38);
  const CanvasState& guide = painted.sim().state();
  for (int c = -1; c < guide.channels; ++c)
    EXPECT_LT(test::reduced_difference(painted.follower().canvas(), guide, c).relative_l2,
              c < 0 ? 0.05 : 0.1)
        << "channel " << c;
}

TEST(DetailFollower, IsNearTheGuideEvenUnlockedInGlazes) {
  test::Painted painted(128, 4, 1, false);
  BrushSettings thin;
  thin.medium_frac = 1.0f;
  thin.pigment_frac = 0.05f;
  painted.sim().set_settings(thin);
  expect_near_the_guide(painted, 33);
}

/// Relative L2 of a stroke's depth.
double off_in_a_stroke(const char* brush) {
  test::Painted painted(128, 4, 1, false);
  painted.sim().set_brush(*builtin_brush(brush));
  painted.stroke(0, 0.03, 0.04, 0.17, 0.1, 0.015f);
  return test::reduced_difference(painted.follower().canvas(), painted.sim().state(), -1)
      .relative_l2;
}

TEST(DetailFollower, SidesOfStrokesAreNearTheGuideEvenUnlocked) {
  // Measured: 0.019, 0.018, 0.032, 0.020, 0.026. Where the guide levels a side against the mean
  // height of its cells it takes too much there: 0.023, 0.032, 0.092, 0.027, 0.047.
  EXPECT_LT(off_in_a_stroke("round"), 0.021);
  EXPECT_LT(off_in_a_stroke("flat"), 0.022);
  EXPECT_LT(off_in_a_stroke("rigger"), 0.04);
  EXPECT_LT(off_in_a_stroke("filbert"), 0.023);
  EXPECT_LT(off_in_a_stroke("knife"), 0.03);
}

TEST(DetailFollower, ABladeIsNearTheGuideEvenUnlocked) {
  test::Painted painted(128, 4, 1, false);
  painted.sim().set_brush(*builtin_brush("knife"));
  painted.cross();
  const CanvasState& guide = painted.sim().state();
  // Measured: 0.026 of the depth, 0.032 to 0.037 of the pigments. With the ends of the blade read
  // at the cells' centres: 0.042, and up to 0.053.
  for (int c = -1; c < guide.channels; ++c)
    EXPECT_LT(test::reduced_difference(painted.follower().canvas(), guide, c).relative_l2,
              c < 0 ? 0.028 : 0.039)
        << "channel " << c;
}

TEST(DetailFollower, LeavesTheGuideAlone) {
  test::Painted with(128, 4), without(128, 4);
  without.sim().set_listener(nullptr);
  with.cross();
  without.cross();
  const CanvasState &a = with.sim().state(), &b = without.sim().state();
  for (int p = -1; p < a.layers * a.channels; ++p)
    for (int y = 0; y < a.geometry.height; ++y)
      ASSERT_EQ(std::memcmp(WetPlane{p}.of(a).row(y), WetPlane{p}.of(b).row(y),
                            static_cast<std::size_t>(a.geometry.width) * sizeof(float)),
                0)
          << "plane " << p << " row " << y;
}

TEST(DetailFollower, HasTheSameBitsForAnyThreadsAndAnyOrderOfTiles) {
  test::Painted one(128, 3);
  one.cross_and_dry();
  for (const int threads : {2, 7}) {
    test::Painted several(128, 3, threads);
    several.cross_and_dry();
    EXPECT_TRUE(test::same_tiles(one.follower().canvas(), several.follower().canvas())) << threads;
  }
  test::Painted reversed(128, 3, Threads::backwards(), true, {});
  reversed.cross_and_dry();
  EXPECT_TRUE(test::same_tiles(one.follower().canvas(), reversed.follower().canvas()));
}

TEST(DetailFollower, HasTheSameBitsWhenItsTilesWereWrittenOut) {
  test::Painted in_memory(128, 4);
  TileStoreOptions scratch;
  scratch.scratch = testing::TempDir();
  scratch.resident_bytes = 512 << 10;  // 8 planes of some 60
  test::Painted in_file(128, 4, Threads(2), true, scratch);
  in_memory.cross_and_dry();
  in_file.cross_and_dry();
  EXPECT_GT(in_file.store().bytes(), 4 * scratch.resident_bytes);
  EXPECT_LE(in_file.store().held_bytes(), scratch.resident_bytes);
  EXPECT_TRUE(test::same_tiles(in_memory.follower().canvas(), in_file.follower().canvas()));
}

TEST(DetailFollower, AFreshCanvasRemembersNoStamp) {
  test::Painted painted(64, 2);
  painted.stamp_once(0.1, 0.07);
  EXPECT_FALSE(painted.follower().checkpoint().stamped.empty());
  painted.sim().clear();
  EXPECT_EQ(painted.follower().checkpoint(), test::Painted(64, 2).follower().checkpoint());
}

/// The cells that the next lock will look at, as the notes have them.
CellBox noted_changed(const test::Painted& painted) {
  const DetailLayout& layout = painted.follower().canvas().layout();
  const DetailCheckpoint checkpoint = painted.follower().checkpoint();
  const int width = layout.guide().width, height = layout.guide().height;
  CellBox box{width, 0, height, 0};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if ((checkpoint.block[static_cast<std::size_t>(y * width + x)] & kCheckpointChanged) == 0)
        continue;
      box = {std::min(box.x0, x), std::max(box.x1, x + 1), std::min(box.y0, y),
             std::max(box.y1, y + 1)};
    }
  return box;
}

TEST(DetailFollower, LocksAStampsCellsAndTheRingAroundThem) {
  test::Painted painted(64, 2);
  painted.stamp_once(0.1, 0.07);
  std::vector<StampedBlock> stamped = painted.follower().checkpoint().stamped;  // by rows
  ASSERT_FALSE(stamped.empty());
  CellBox box{stamped[0].x, stamped[0].x + 1, stamped[0].y, stamped.back().y + 1};
  for (const StampedBlock& block : stamped)
    box = {std::min(box.x0, block.x), std::max(box.x1, block.x + 1), box.y0, box.y1};
  const CellBox changed = noted_changed(painted);
  EXPECT_EQ(changed.x0, box.x0 - 1);
  EXPECT_EQ(changed.x1, box.x1 + 1);
  EXPECT_EQ(changed.y0, box.y0 - 1);
  EXPECT_EQ(changed.y1, box.y1 + 1);
}

/// A step of a canvas of 64 x 48 cells with the brush in the air.
struct StepWithoutBrush {
  explicit StepWithoutBrush(const CanvasState& guide)
      : amount(static_cast<std::size_t>(guide.channels), 1.0f) {}
  const Threads threads{1};
  const Model model;
  const BrushContact contact = make_brush_contact(64, 48);
  const std::vector<float> amount;
  const StepInput in{model, {0, 0, 9.81f}, 1.0f / 45, contact, amount, threads};
};

TEST(DetailFollower, LocksAStampThatChangedTheFineCellsAlone) {
  test::Painted painted(64, 2);
  painted.stroke(0, 0.05, 0.07, 0.15, 0.07);
  const CanvasState guide = clone_state(painted.sim().state());
  painted.stamp_once(0.1, 0.07);
  // The guide holds what it held before the stamp.
  const StepWithoutBrush step(guide);
  painted.follower().stepped(guide, step.in);
  for (int c = -1; c < guide.channels; ++c)
    EXPECT_LT(test::reduced_difference(painted.follower().canvas(), guide, c).relative_l2, kExact)
        << "channel " << c;
}

TEST(DetailFollower, EdgesOfAPartOfAStepDoNotMoveTheNext) {
  // paint_edges.h: the follower puts back to 0 what the scheme wrote.
  test::Painted painted(64, 2);
  painted.stroke(0, 0.05, 0.07, 0.15, 0.07);
  const CanvasState& guide = painted.sim().state();
  DetailFollower& follower = painted.follower();
  const StepWithoutBrush step(guide);
  std::vector<conservative::Run> runs;
  for (int y = 10; y < 40; ++y) runs.push_back({y, 8, 56});
  PaintEdges& edges = follower.edges();
  for (std::size_t quantity = 0; quantity < edges.x.size(); ++quantity)
    for (const conservative::Run& run : runs)
      for (int x = run.x0; x < run.x1; ++x)
        edges.x[quantity](x, run.y) = edges.y[quantity](x, run.y) = 0.25f;
  follower.moved(guide, step.in, runs);
  for (std::size_t quantity = 0; quantity < edges.x.size(); ++quantity)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 64; ++x) {
        EXPECT_EQ(edges.x[quantity](x, y), 0);
        EXPECT_EQ(edges.y[quantity](x, y), 0);
      }
}

}  // namespace
}  // namespace pentimento
