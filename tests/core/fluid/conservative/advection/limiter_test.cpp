#include "core/fluid/conservative/advection/limiter.h"

#include <gtest/gtest.h>

namespace pentimento::conservative {
namespace {

TEST(Limiter, SuperbeeHasTheSlopesOfItsDefinition) {
  // Sweby's diagram: slope / below over r = above / below is max(min(2, r), min(1, 2 r)).
  for (const float sign : {1.0f, -1.0f}) {
    EXPECT_EQ(limited_superbee(4 * sign, 1 * sign), 2 * sign);   // r = 1/4: 2 r
    EXPECT_EQ(limited_superbee(4 * sign, 3 * sign), 4 * sign);   // 1
    EXPECT_EQ(limited_superbee(4 * sign, 6 * sign), 6 * sign);   // r
    EXPECT_EQ(limited_superbee(4 * sign, 12 * sign), 8 * sign);  // 2
    EXPECT_EQ(half_limited_superbee(4 * sign, 12 * sign), 4 * sign);
  }
}

TEST(Limiter, McHasTheSlopesOfItsDefinition) {
  // max(0, min(2 r, (1 + r) / 2, 2)).
  for (const float sign : {1.0f, -1.0f}) {
    EXPECT_EQ(limited_mc(4 * sign, 1 * sign), 2 * sign);
    EXPECT_EQ(limited_mc(4 * sign, 6 * sign), 5 * sign);
    EXPECT_EQ(limited_mc(4 * sign, 16 * sign), 8 * sign);
    EXPECT_EQ(half_limited_mc(4 * sign, 16 * sign), 4 * sign);
  }
}

TEST(Limiter, ExtremaAreFlat) {
  EXPECT_EQ(limited_mc(1, -2), 0);
  EXPECT_EQ(half_limited_mc(1, -2), 0);
  EXPECT_EQ(limited_superbee(-1, 2), 0);
  EXPECT_EQ(limited_superbee(0, 2), 0);
}

}  // namespace
}  // namespace pentimento::conservative
