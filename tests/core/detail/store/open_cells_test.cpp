#include "core/detail/store/open_cells.h"

#include <gtest/gtest.h>

#include "tests/core/detail/painted.h"

namespace pentimento {
namespace {

TEST(OpeningOf, TakesTheLowestFreeLayerOrMakesRoom) {
  const std::vector<float> bare = {0, 0}, one = {1, 0}, full = {1, 2}, gap = {0, 1};
  EXPECT_EQ(opening_of(bare).target, 0);
  EXPECT_EQ(opening_of(one).target, 1);
  EXPECT_FALSE(opening_of(one).merges);
  EXPECT_EQ(opening_of(full).target, 1);
  EXPECT_TRUE(opening_of(full).merges);
  EXPECT_EQ(opening_of(gap).to[1], 0);  // holes close
  EXPECT_EQ(layer_on_top(full), 1);
  EXPECT_EQ(layer_on_top(bare), 0);
}

class OpenCellsTest : public ::testing::Test {
 protected:
  OpenCellsTest() {
    canvas_.at(0);
    make_openable(canvas_.find(0)->open, layout_);
    for (const int p : {0, 1}) canvas_.make(canvas_.find(0)->pigment[static_cast<std::size_t>(p)]);
  }
  LayerRow row() {
    planes_ = {canvas_.find(0)->pigment[0].data(), canvas_.find(0)->pigment[1].data()};
    return {planes_, 0, 2, 1, amount_};
  }
  const DetailLayout layout_{{8, 8, 1, 1}, 4};
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 2, 1, 3, substrate_, *store_};
  std::vector<float*> planes_;
  std::vector<float> amount_ = {1};
};

TEST_F(OpenCellsTest, OnlyTouchedCellsFollow) {
  const LayerRow cells = row();
  for (int x = 0; x < 4; ++x) cells.at(0, 0, x) = cells.at(1, 0, x) = 1;
  const std::vector<float> full = {1, 1};
  await_tip(*canvas_.find(0), layout_, 0, 0, 2, opening_of(full));
  EXPECT_FALSE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
  open_cell(*canvas_.find(0), layout_, cells, 1, 0, 1);
  EXPECT_EQ(cells.at(0, 0, 1), 2);  // merged, room above
  EXPECT_EQ(cells.at(1, 0, 1), 0);
  EXPECT_EQ(cells.at(1, 0, 0), 1);  // not touched
  open_cell(*canvas_.find(0), layout_, cells, 1, 0, 1);
  EXPECT_EQ(cells.at(0, 0, 1), 2);  // once
}

TEST_F(OpenCellsTest, CorrespondAgainOnceAllAreOpen) {
  const std::vector<float> full = {1, 1};
  await_tip(*canvas_.find(0), layout_, 0, 0, 2, opening_of(full));
  const LayerRow cells = row();
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      EXPECT_FALSE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
      open_cell(*canvas_.find(0), layout_, cells, x, y, y * layout_.side() + x);
    }
  EXPECT_TRUE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
  EXPECT_TRUE(layers_correspond(*canvas_.find(0), layout_, 1, 0));  // nobody opened it
}

}  // namespace
}  // namespace pentimento
