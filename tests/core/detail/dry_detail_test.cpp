#include "core/detail/dry_detail.h"

#include <gtest/gtest.h>

#include "core/detail/store/open_cells.h"
#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

TEST(DryDetail, NoCellWaitsForTheTipAfterwards) {
  // A block whose guide cell opened a layer, and whose fine cells wait: once all is dry, the layers
  // of both are empty again.
  const DetailLayout layout({8, 8, 1, 1}, 4);
  const test::PlainSubstrate substrate;
  const auto store = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas(layout, 2, 3, 3, substrate, *store);
  DetailTile& tile = canvas.at(0);
  make_openable(tile.open, layout);
  for (TilePlane* plane : {&tile.depth_m, &tile.base_m, &tile.pigment[0]}) canvas.make(*plane);
  tile.depth_m.data()[0] = 0.001f;
  await_tip(tile, layout, 0, 0, 2, opening_of(std::vector<float>{1, 1}));
  ASSERT_FALSE(layers_correspond(tile, layout, 0, 0));
  dry_detail(canvas, palette_channels(test::three_pigments()), Model{}, Threads(1));
  EXPECT_TRUE(tile.open.empty());
  EXPECT_TRUE(layers_correspond(tile, layout, 0, 0));
  EXPECT_FALSE(tile.depth_m);
}

}  // namespace
}  // namespace pentimento
