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
  }
  const DetailLayout layout_{{8, 8, 1, 1}, 4};
  test::PlainSubstrate substrate_;
  std::unique_ptr<TileStore> store_ = std::move(*TileStore::open({128 * 128, "", 0}));
  DetailCanvas canvas_{layout_, 2, 1, 3, substrate_, *store_};
};

TEST_F(OpenCellsTest, CellsOfTheBlockWaitForTheTip) {
  const std::vector<float> full = {1, 1};
  EXPECT_TRUE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
  await_tip(*canvas_.find(0), layout_, 0, 0, 2, opening_of(full));
  EXPECT_FALSE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
  EXPECT_EQ(opening_in(*canvas_.find(0), layout_, 0, 0), opening_of(full));
  const std::vector<std::uint8_t>& opened = canvas_.find(0)->open.opened;
  for (int y = 0; y < layout_.side(); ++y)
    for (int x = 0; x < layout_.side(); ++x)
      ASSERT_EQ(opened[static_cast<std::size_t>(y * layout_.side() + x)], x < 4 && y < 4 ? 0 : 1);
}

TEST_F(OpenCellsTest, CorrespondAgainOnceAllAreOpen) {
  const std::vector<float> full = {1, 1};
  await_tip(*canvas_.find(0), layout_, 0, 0, 2, opening_of(full));
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      EXPECT_FALSE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
      canvas_.find(0)->open.opened[static_cast<std::size_t>(y * layout_.side() + x)] = 1;
    }
  EXPECT_TRUE(layers_correspond(*canvas_.find(0), layout_, 0, 0));
  EXPECT_TRUE(layers_correspond(*canvas_.find(0), layout_, 1, 0));  // nobody opened it
}

}  // namespace
}  // namespace pentimento
