#include "core/fluid/paper/departure.h"

#include <gtest/gtest.h>

namespace pentimento::paper {
namespace {

TEST(Departure, LiesBetweenTheCellsThatItIsMixedFrom) {
  const Departure p = depart(5, 3, 1.25f, -0.5f, {10, 8, 16});
  EXPECT_EQ(p.x0, 3);
  EXPECT_EQ(p.x1, 4);
  EXPECT_EQ(p.y0, 3);
  EXPECT_EQ(p.y1, 4);
  EXPECT_EQ(p.fx, 0.75f);
  EXPECT_EQ(p.fy, 0.5f);
  EXPECT_EQ(p.bottom_right, 4 * 16 + 4);
}

TEST(Departure, NothingComesFromOutside) {
  // From beyond each corner: the corner's cell, on either side of the point.
  for (const float far : {0.5f, 1.0f, 1e6f})
    for (const int right : {0, 1})
      for (const int low : {0, 1}) {
        const int x = right != 0 ? 9 : 0, y = low != 0 ? 7 : 0;
        const Departure p =
            depart(x, y, right != 0 ? -far : far, low != 0 ? -far : far, {10, 8, 16});
        EXPECT_EQ(p.x0, x);
        EXPECT_EQ(p.x1, right != 0 ? 9 : 1);
        EXPECT_EQ(p.y0, y);
        EXPECT_EQ(p.y1, low != 0 ? 7 : 1);
        EXPECT_EQ(p.fx, 0.0f);
        EXPECT_EQ(p.fy, 0.0f);
      }
}

}  // namespace
}  // namespace pentimento::paper
