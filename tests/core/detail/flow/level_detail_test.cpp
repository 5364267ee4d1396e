#include "core/detail/flow/level_detail.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/detail/flow/moving_blocks.h"
#include "core/detail/lock/lock.h"
#include "core/fluid/brush_contact.h"
#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

/// A guide of 32 x 32 cells of 1 mm under runny paint left of a front at 45 degrees, all moving.
class LevelTest : public ::testing::Test {
 protected:
  static constexpr int kFactor = 8;
  LevelTest()
      : guide_(make_canvas_state({32, 32, 0.032, 0.032}, 1, 1, 3, 1.0f)),
        edges_(guide_.geometry, 1),
        contact_(make_brush_contact(32, 32)) {
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x + y < 32; ++x) {
        guide_.depth_m(x, y) = 0.001f;
        guide_.channel(0, 0)(x, y) = 0.001f;  // 1 per metre: runs
        edges_.x[0](x, y) = edges_.y[0](x, y) = 0.1f;
      }
    for (int t = 0; t < layout_.tiles(); ++t) {
      canvas_.ensure_planes(t, guide_);
      DetailTile* tile = canvas_.find(t);
      if (tile == nullptr) continue;
      for (int y = 0; y < tile->box.height() * kFactor; ++y)
        for (int x = 0; x < tile->box.width() * kFactor; ++x) {
          const int gx = tile->box.x0 + x / kFactor, gy = tile->box.y0 + y / kFactor;
          const std::size_t i = static_cast<std::size_t>(y * layout_.side() + x);
          tile->depth_m.data()[i] = guide_.depth_m(gx, gy);
          tile->pigment[0].data()[i] = guide_.channel(0, 0)(gx, gy);
        }
    }
  }

  void level(float pigment_scale, int steps) {
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) guide_.channel(0, 0)(x, y) *= pigment_scale;
    const StepInput in{model_, {0, 0, 9.81f}, 1.0f / 45, contact_, amount_, threads_};
    ChangedBlocks all(layout_);
    all.add({0, 32, 0, 32});
    Lock lock(layout_);
    for (int i = 0; i < steps; ++i) {
      level_detail(canvas_, guide_, edges_, in, all);
      lock.lock(canvas_, guide_, all.strips(), threads_);
    }
  }
  float depth_at(int x, int y) {
    const int side = layout_.side();
    const DetailTile* tile = canvas_.find(layout_.tile_of(x / side, y / side));
    return tile == nullptr || !tile->depth_m ? 0.0f
                                             : tile->depth_m.data()[y % side * side + x % side];
  }
  /// Where row y falls below half the film, in fine cells.
  int front_of(int y) {
    int x = 255;
    while (x > 0 && depth_at(x, y) < 0.0005f) --x;
    return x;
  }

  const DetailLayout layout_{{32, 32, 0.032, 0.032}, kFactor};
  CanvasState guide_;
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 1, 1, 3, substrate_, *store_};
  PaintEdges edges_;
  BrushContact contact_;
  Model model_;
  std::vector<float> amount_ = {1};
  Threads threads_{1};
};

TEST_F(LevelTest, AFrontAtAnAngleLosesItsStaircase) {
  const auto unevenness = [&] {  // of x + y along the front, mean over rows of the middle
    double most = 0, least = 1e9;
    for (int y = 80; y < 176; ++y) {
      most = std::max(most, static_cast<double>(front_of(y) + y));
      least = std::min(least, static_cast<double>(front_of(y) + y));
    }
    return most - least;
  };
  EXPECT_EQ(unevenness(), kFactor - 1);  // the guide's cells
  // Its corners, which tension drains (surface_tension_test.cpp), must hold their paint somewhere:
  // a quarter of a cell of the staircase remains.
  for (int x = 0; x < 32; ++x)
    guide_.depth_m(x, 31 - x) = guide_.channel(0, 0)(x, 31 - x) = 0.0004f;
  level(1, 40);
  EXPECT_LE(unevenness(), 2);
}

TEST_F(LevelTest, StiffPaintKeepsItsShape) {
  const int before = front_of(84);
  level(30, 5);  // 30 per metre stands
  EXPECT_EQ(front_of(84), before);
}

TEST_F(LevelTest, RipplesOfAMillimetreFadeAsInAThinFilm) {
  // An even film that moves everywhere: what stands out of it loses r / (1 + r) in a step, with
  // Reynolds' rate of a ripple of wave number q, r = dt g d^3 q^2 / (3 nu), on paint that gravity
  // moves freely and whose viscosity is the floor of the friction.
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      guide_.depth_m(x, y) = guide_.channel(0, 0)(x, y) = 0.001f;
      edges_.x[0](x, y) = 0.1f;
    }
  for (int t = 0; t < layout_.tiles(); ++t) {
    canvas_.ensure_planes(t, guide_);
    std::fill_n(canvas_.find(t)->depth_m.data(), 128 * 128, 0.0012f);
  }
  const StepInput in{model_, {0, 0, 9.81f}, 1.0f / 45, contact_, amount_, threads_};
  ChangedBlocks all(layout_);
  all.add({0, 32, 0, 32});
  level_detail(canvas_, guide_, edges_, in, all);
  const double q = 2 * 3.14159265 / 0.001;
  const double r = 9.81 / 45 * 1e-9 * q * q / (3 * 1e-3);
  // 1.3 %: q^2 is rounded to 4e7.
  EXPECT_NEAR((static_cast<double>(depth_at(128, 128)) - 0.001) / 0.0002 * (1 + r), 1, 0.02);
}

TEST_F(LevelTest, ReachesAsFarOnEverySideOfAMovingEdge) {
  // An even film, one edge that moves: its two cells and one around them level, and the spline
  // takes it two cells further.
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) guide_.depth_m(x, y) = guide_.channel(0, 0)(x, y) = 0.001f;
  const StepInput in{model_, {0, 0, 9.81f}, 1.0f / 45, contact_, amount_, threads_};
  ChangedBlocks all(layout_);
  all.add({0, 32, 0, 32});
  const auto changed_by = [&](const PaintEdges& edges) {
    for (int t = 0; t < layout_.tiles(); ++t) {
      canvas_.ensure_planes(t, guide_);
      std::fill_n(canvas_.find(t)->depth_m.data(), 128 * 128, 0.0012f);
    }
    level_detail(canvas_, guide_, edges, in, all);
    CellBox changed{32, 0, 32, 0};
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) {
        if (depth_at(x, y) == 0.0012f) continue;
        changed = {std::min(changed.x0, x / kFactor), std::max(changed.x1, x / kFactor + 1),
                   std::min(changed.y0, y / kFactor), std::max(changed.y1, y / kFactor + 1)};
      }
    return std::vector<int>{changed.x0, changed.x1, changed.y0, changed.y1};
  };
  PaintEdges along_x(guide_.geometry, 1), along_y(guide_.geometry, 1);
  along_x.x[0](12, 15) = 0.1f;  // between columns 12 and 13
  along_y.y[0](15, 12) = 0.1f;
  EXPECT_EQ(changed_by(along_x), (std::vector<int>{12 - 3, 14 + 3, 15 - 3, 16 + 3}));
  EXPECT_EQ(changed_by(along_y), (std::vector<int>{15 - 3, 16 + 3, 12 - 3, 14 + 3}));
}

TEST_F(LevelTest, ChangesNothingBeyondWhatMoves) {
  // One edge moves: what the lock is told of must hold all that changes.
  edges_ = PaintEdges(guide_.geometry, 1);
  edges_.x[0](12, 12) = 0.1f;
  std::vector<conservative::Run> runs;
  for (int y = 0; y < 32; ++y) runs.push_back({y, 0, 32});
  ChangedBlocks moving(layout_);
  add_moving(edges_, runs, moving);
  std::vector<float> before;
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) before.push_back(depth_at(x, y));
  guide_.depth_m(12, 12) = 0.002f;  // a bump that levels
  const StepInput in{model_, {0, 0, 9.81f}, 1.0f / 45, contact_, amount_, threads_};
  level_detail(canvas_, guide_, edges_, in, moving);
  CellBox changed{32, 0, 32, 0};
  for (int y = 0; y < 256; ++y)
    for (int x = 0; x < 256; ++x) {
      if (depth_at(x, y) == before[static_cast<std::size_t>(y * 256 + x)]) continue;
      changed = {std::min(changed.x0, x / kFactor), std::max(changed.x1, x / kFactor + 1),
                 std::min(changed.y0, y / kFactor), std::max(changed.y1, y / kFactor + 1)};
    }
  ASSERT_LT(changed.x0, changed.x1);
  for (int y = changed.y0; y < changed.y1; ++y)
    for (int x = changed.x0; x < changed.x1; ++x) {
      const std::vector<BlockStrip> strips = moving.strips();
      EXPECT_TRUE(
          std::any_of(strips.begin(), strips.end(),
                      [&](const BlockStrip& s) { return s.y == y && s.x0 <= x && x < s.x1; }))
          << x << ", " << y;
    }
}

TEST_F(LevelTest, ReducesToTheGuideAfterwards) {
  level(1, 10);
  for (const int p : {-1, 0})
    EXPECT_LT(test::reduced_difference(canvas_, guide_, p).relative_l2,
              5e-7);  // rounding of each cell
}

}  // namespace
}  // namespace pentimento
