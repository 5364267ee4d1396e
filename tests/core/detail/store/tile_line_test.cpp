#include "core/detail/store/tile_line.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

// 5 x 3 tiles of 4 x 4 blocks; those of the middle row in columns 0, 1, 3 and 4 have changed.
std::vector<TileRun> runs_along(Axis axis) {
  const DetailLayout layout({20, 12, 1, 1}, 32);
  ChangedBlocks changed(layout);
  for (const int x : {0, 4, 12, 16}) changed.add(4, x, x + 1);
  return runs_of(layout, changed, axis);
}

TEST(TileLine, ATileThatStandsStillEndsARun) {
  const std::vector<TileRun> runs = runs_along(Axis::kX);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].tiles, (std::vector<int>{5, 6}));
  EXPECT_EQ(runs[1].tiles, (std::vector<int>{8, 9}));
  EXPECT_EQ(runs[1].box.x0, 12);
  EXPECT_EQ(runs[1].box.x1, 20);
}

TEST(TileLine, AcrossTheLineEveryTileIsARunOfItsOwn) {
  const std::vector<TileRun> runs = runs_along(Axis::kY);
  ASSERT_EQ(runs.size(), 4u);
  for (const TileRun& run : runs) EXPECT_EQ(run.tiles.size(), 1u);
}

/// Three tiles of 64 x 64 fine cells in a row or a column, of which the second has no depth.
class LinesTest : public ::testing::TestWithParam<Axis> {
 protected:
  LinesTest()
      : along_x_(GetParam() == Axis::kX),
        layout_(along_x_ ? CanvasGeometry{48, 16, 1, 1} : CanvasGeometry{16, 48, 1, 1}, 8),
        guide_(make_canvas_state(layout_.guide(), 1, 1, 3, 1.0f)),
        store_(std::move(*TileStore::open({128 * 128, "", 0}))),
        canvas_(layout_, 1, 1, 3, substrate_, *store_) {
    ChangedBlocks all(layout_);
    all.add({0, layout_.guide().width, 0, layout_.guide().height});
    run_ = runs_of(layout_, all, GetParam()).front();
    for (const int lit : {0, 2}) {
      const int first = 16 * lit;
      guide_.depth_m(along_x_ ? first : 0, along_x_ ? 0 : first) = 1;
      canvas_.ensure_planes(lit, guide_);
      for (int i = 0; i < 128 * 128; ++i)
        canvas_.find(lit)->depth_m.data()[i] = static_cast<float>(1 + i + lit * 100000);
    }
  }
  /// What the tiles hold at a place along a line.
  float plain(int line, int place) const {
    const DetailTile* tile = canvas_.find(place / 128);
    if (tile == nullptr || !tile->depth_m) return 0;
    const int at = place % 128;
    return tile->depth_m.data()[along_x_ ? line * 128 + at : at * 128 + line];
  }

  const bool along_x_;
  const DetailLayout layout_;
  CanvasState guide_;
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_;
  DetailCanvas canvas_;
  TileRun run_;
};

TEST_P(LinesTest, AreLoadedAndStoredAcrossTiles) {
  constexpr int kStride = 400;
  // From the middle of the first tile to the middle of the last; seven lines, no whole fours.
  const LineRange range{45, 7, 70, 233};
  std::vector<float> lines(7 * kStride, -1.0f);
  load_lines(canvas_, run_, WetPlane{}, range, {lines.data(), kStride});
  for (int l = 0; l < 7; ++l)
    for (int i = 0; i < kStride; ++i)
      ASSERT_EQ(lines[static_cast<std::size_t>(l * kStride + i)],
                i < 233 ? plain(45 + l, 70 + i) : -1.0f)
          << l << ", " << i;
  // Stored, they are found in their place and nowhere else.
  for (float& value : lines) value = -value;
  store_lines(canvas_, run_, WetPlane{}, range, {lines.data(), kStride});
  for (int line = 0; line < 128; ++line)
    for (int place = 0; place < 384; ++place) {
      const bool inside = line >= 45 && line < 52 && place >= 70 && place < 303;
      const bool changed = plain(line, place) < 0;
      ASSERT_EQ(changed, inside && place / 128 != 1) << line << ", " << place;
      const float stored = changed
                               ? lines[static_cast<std::size_t>((line - 45) * kStride + place - 70)]
                               : plain(line, place);
      ASSERT_EQ(plain(line, place), stored) << line << ", " << place;
    }
}

INSTANTIATE_TEST_SUITE_P(TileLine, LinesTest, ::testing::Values(Axis::kX, Axis::kY));

}  // namespace
}  // namespace pentimento
