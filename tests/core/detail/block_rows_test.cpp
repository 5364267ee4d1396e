#include "core/detail/block_rows.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

TEST(BlockMeans, AreTheMeansOfTheirCells) {
  const int k = 3, side = 9;
  std::vector<float> plane(81);
  for (std::size_t i = 0; i < plane.size(); ++i) plane[i] = static_cast<float>(i);
  std::vector<float> mean(6);
  block_means(plane.data(), side, k, {0, 3, 0, 2}, mean);
  EXPECT_FLOAT_EQ(mean[0], 10);  // the middle cell of the first block
  EXPECT_FLOAT_EQ(mean[1], 13);
  EXPECT_FLOAT_EQ(mean[3], 37);
}

TEST(ScaleByField, IsTheFieldAtCentresAndLinearBetween) {
  const int k = 3;
  Field<float> ratio(4, 2, 1.0f);
  ratio(1, 0) = ratio(1, 1) = 4;
  std::vector<float> plane(144, 2.0f);
  scale_by_field(ratio.view(), k, {0, 4, 0, 2}, plane.data(), 12);
  EXPECT_FLOAT_EQ(plane[1], 2);     // centre of cell 0
  EXPECT_FLOAT_EQ(plane[4], 8);     // centre of cell 1
  EXPECT_NEAR(plane[3], 6, 1e-5f);  // two thirds on from centre 0
  EXPECT_FLOAT_EQ(plane[11], 2);    // beyond the last centre
}

TEST(ScaleBlocks, ScalesEachBlockAlone) {
  std::vector<float> plane(16, 1.0f);
  const std::vector<float> scale = {1, 2, 0, 0.5f};
  scale_blocks(scale, 2, {0, 2, 0, 2}, plane.data(), 4);
  EXPECT_EQ(plane,
            (std::vector<float>{1, 1, 2, 2, 1, 1, 2, 2, 0, 0, 0.5f, 0.5f, 0, 0, 0.5f, 0.5f}));
}

}  // namespace
}  // namespace pentimento
