#include "core/fluid/conservative/solve/viscous_row.h"

#include <gtest/gtest.h>

namespace pentimento::conservative {
namespace {

struct Node {
  float cx = 0, cy = 0, zero_order = 0, rhs = 0;
};

/// The middle one of three nodes in a row, between the depths `left` and `right`, `above` and
/// `below`; dt / dx^2 = 4, dt / dy^2 = 1.
Node middle(float left, float right, float above, float below) {
  const float depth[3] = {left, 1, right}, up[3] = {0, above, 0}, down[3] = {0, below, 0};
  const float nu[3] = {0, 2, 6}, nu_below[3] = {0, 10, 0}, u[3] = {0, 5, 0};
  float cx[3] = {}, cy[3] = {}, z[3] = {}, rhs[3] = {};
  viscous_row({up + 1, depth + 1, down + 1, nu + 1, nu_below + 1, u + 1}, 4, 1, 1,
              {cx + 1, cy + 1, z + 1, rhs + 1});
  return {cx[1], cy[1], z[1], rhs[1]};
}

TEST(ViscousRow, CouplesWetNodesByTheMeanViscosityAndTheirOwnAxis) {
  const Node n = middle(1, 1, 1, 1);
  EXPECT_EQ(n.cx, 4 * (2 + 6) / 2);
  EXPECT_EQ(n.cy, 1 * (2 + 10) / 2);
  EXPECT_EQ(n.zero_order, 1);
  EXPECT_EQ(n.rhs, 5);
}

TEST(ViscousRow, DryNeighboursHoldAndTheWallSlips) {
  EXPECT_EQ(middle(0, 1, 1, 1).zero_order, 1 + 4 * 2);
  EXPECT_EQ(middle(1, 0, 1, 1).zero_order, 1 + 4 * 2);
  EXPECT_EQ(middle(1, 1, 0, 1).zero_order, 1 + 1 * 2);
  EXPECT_EQ(middle(1, 1, 1, 0).zero_order, 1 + 1 * 2);
  EXPECT_EQ(middle(-1, -1, -1, -1).zero_order, 1);
  EXPECT_EQ(middle(1, 0, 1, 1).cx, 0);
  EXPECT_EQ(middle(1, 1, 1, 0).cy, 0);
}

}  // namespace
}  // namespace pentimento::conservative
