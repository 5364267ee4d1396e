#include "core/detail/flow/advect_detail.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

/// A guide of 32 x 32 cells in 2 x 2 tiles, one wet layer, whose fine cells are all different.
class MoveDetailTest : public ::testing::Test {
 protected:
  static constexpr int kFactor = 8;
  MoveDetailTest()
      : guide_(make_canvas_state({32, 32, 0.032, 0.032}, 1, 1, 3, 1.0f)),
        edges_(guide_.geometry, 1) {
    guide_.depth_m.fill(0.001f);
    guide_.channel(0, 0).fill(0.001f);
    for (int t = 0; t < layout_.tiles(); ++t) {
      canvas_.ensure_planes(t, guide_);
      for (int i = 0; i < 128 * 128; ++i) {
        canvas_.find(t)->depth_m.data()[i] = 0.001f + 1e-7f * static_cast<float>(i % 331);
        canvas_.find(t)->pigment[0].data()[i] = 0.002f;
      }
    }
  }

  void move(Axis axis, const ChangedBlocks& moving) {
    advect_detail(canvas_, edges_, axis, moving, {0, amount_}, Threads(1));
  }
  float depth_at(int x, int y) const {
    const int side = layout_.side();
    const DetailTile* tile = canvas_.find(layout_.tile_of(x / side, y / side));
    return tile->depth_m.data()[y % side * side + x % side];
  }
  void set_depth(int x, int y, float depth) {
    const int side = layout_.side();
    canvas_.find(layout_.tile_of(x / side, y / side))->depth_m.data()[y % side * side + x % side] =
        depth;
  }
  std::vector<float> depths() const {
    std::vector<float> out;
    for (int y = 0; y < 256; ++y)
      for (int x = 0; x < 256; ++x) out.push_back(depth_at(x, y));
    return out;
  }

  const DetailLayout layout_{{32, 32, 0.032, 0.032}, kFactor};
  CanvasState guide_;
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 1, 1, 3, substrate_, *store_};
  PaintEdges edges_;
  std::array<float, 1> amount_ = {1};
};

TEST_F(MoveDetailTest, AnEvenShiftCarriesAPlateauAlong) {
  // Edges 2 to 25 of every row move by a quarter of a cell, two fine cells: what lies well between
  // them is found two fine cells further, with every digit of a float.
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    ChangedBlocks all(layout_);
    all.add({0, 32, 0, 32});
    const std::vector<float> before = depths();
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        const int along = axis == Axis::kX ? x : y;
        (axis == Axis::kX ? edges_.x : edges_.y)[0](x, y) = along >= 2 && along < 26 ? 0.25f : 0.0f;
      }
    move(axis, all);
    const int dx = axis == Axis::kX ? 2 : 0, dy = 2 - dx;
    for (int y = 48; y < 192; ++y)
      for (int x = 48; x < 192; ++x)
        // Shares of a cell's length have the rounding of a position of 256 cells, 3e-5.
        EXPECT_NEAR(depth_at(x + dx, y + dy), before[static_cast<std::size_t>(y * 256 + x)], 5e-9f);
  }
}

TEST_F(MoveDetailTest, AShortRunOfTilesKnowsNothingOfALongOneBeforeIt) {
  // The upper tiles move together across the border between them; in the lower left tile edges
  // far from its right border move, and there nothing does.
  for (int y = 0; y < 4; ++y) edges_.x[0](15, y) = 0.25f;
  for (int y = 20; y < 28; ++y) edges_.x[0](3, y) = 0.25f;
  ChangedBlocks moving(layout_);
  for (int y = 0; y < 4; ++y) moving.add(y, 12, 20);
  for (int y = 20; y < 28; ++y) moving.add(y, 0, 8);
  const std::vector<float> before = depths();
  move(Axis::kX, moving);
  EXPECT_NE(depth_at(128, 12), before[12 * 256 + 128]);
  EXPECT_NE(depth_at(32, 192), before[192 * 256 + 32]);
  for (int y = 128; y < 256; ++y)
    for (int x = 64; x < 256; ++x)
      EXPECT_EQ(depth_at(x, y), before[static_cast<std::size_t>(y * 256 + x)]) << x << ", " << y;
}

TEST_F(MoveDetailTest, LinesThatMoveTogetherDoNotMix) {
  // Each row and column of the guide has two parts that move, elsewhere than its neighbour's. Block
  // 11 stands still in all. Lines moved with others must come out as they do when nothing else
  // moves.
  const auto edges_of = [](int across, int along) {
    const int shift = across % 5;
    const bool first = along >= 2 + shift && along < 6 + shift;
    const bool second = along >= 12 + 2 * shift && along < 27;
    return first ? 0.2f : second ? -0.15f : 0.0f;
  };
  const std::vector<float> before = depths();
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const auto moved = [&](int lowest, int highest) {
      for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x)
          set_depth(x, y, before[static_cast<std::size_t>(y * 256 + x)]);
      PaintEdges& e = edges_;
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
          const int across = axis == Axis::kX ? y : x, along = axis == Axis::kX ? x : y;
          (axis == Axis::kX ? e.x : e.y)[0](x, y) =
              across >= lowest && across <= highest ? edges_of(across, along) : 0.0f;
        }
      ChangedBlocks all(layout_);
      all.add({0, 32, 0, 32});
      move(axis, all);
      return depths();
    };
    const std::vector<float> together = moved(0, 31);
    EXPECT_NE(together, before);
    // What stands still beside a part that moves is as before, also where it moves in other lines.
    const auto still = [&](int across, int block) {
      return edges_of(across, block - 1) == 0 && edges_of(across, block) == 0;
    };
    int unmoved = 0;
    for (int line = 0; line < 31 * kFactor; ++line)
      for (int i = kFactor; i < 256; ++i) {
        const int across = line / kFactor, block = i / kFactor;
        if (!still(across, block) || !still(across + 1, block)) continue;
        const int beside = line + kFactor / 2;  // between the centres of both
        const int at = axis == Axis::kX ? beside * 256 + i : i * 256 + beside;
        ASSERT_EQ(together[static_cast<std::size_t>(at)], before[static_cast<std::size_t>(at)])
            << beside << ", " << i;
        ++unmoved;
      }
    EXPECT_GT(unmoved, 1000);
    // Guide lines 9 to 11 alone give the fine lines between the centres of 9 and 11.
    const std::vector<float> alone = moved(9, 11);
    for (int line = 9 * kFactor + kFactor / 2; line < 11 * kFactor + kFactor / 2; ++line)
      for (int i = 0; i < 256; ++i) {
        const int at = axis == Axis::kX ? line * 256 + i : i * 256 + line;
        ASSERT_EQ(together[static_cast<std::size_t>(at)], alone[static_cast<std::size_t>(at)])
            << line << ", " << i;
      }
  }
}

}  // namespace
}  // namespace pentimento
