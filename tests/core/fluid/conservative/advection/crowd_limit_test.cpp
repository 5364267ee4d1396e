#include "core/fluid/conservative/advection/crowd_limit.h"

#include <gtest/gtest.h>

#include <array>

namespace pentimento::conservative {
namespace {

using Edges = std::array<float, 4>;

/// The four edges of three cells of one depth, limited; the depth that motion may reach is 1.
Edges limited(float depth, Edges edge) {
  const std::array<float, 5> depths = {depth, depth, depth, depth, depth};
  limit_crowding({3, 1, 1}, depths.data() + 1, edge.data());
  return edge;
}

TEST(LimitCrowding, KeepsEdgesAsFarApartAsThePaintBetweenThemNeeds) {
  // The edges of the middle cell meet in its middle. Full cells stay as they are; cells half full
  // may be half as long, which the forward pass settles.
  EXPECT_EQ(limited(1, {0, 0.5f, -0.5f, 0}), (Edges{0, 0, 0, 0}));
  EXPECT_EQ(limited(0.5f, {0, 0.5f, -0.5f, 0}), (Edges{0, 0.5f, 0, 0}));
  EXPECT_EQ(limited(0, {0, 0.5f, -0.5f, 0}), (Edges{0, 0.5f, -0.5f, 0}));
  EXPECT_EQ(limited(2, {0, 0.5f, -0.5f, 0}), (Edges{0, 0, 0, 0}));  // no longer than it is
}

TEST(LimitCrowding, LeavesEdgesThatComeNoNearerAlone) {
  Edges apart = {0, -0.5f, 0.5f, 0};
  const std::array<float, 5> depths = {0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
  EXPECT_FALSE(limit_crowding({3, 1, 1}, depths.data() + 1, apart.data()));
  EXPECT_EQ(apart, (Edges{0, -0.5f, 0.5f, 0}));
}

TEST(LimitCrowding, TheDeepestNeighbourCountsToo) {
  // The middle cell is bare, the one to its right is full.
  const std::array<float, 5> depths = {0, 0, 0, 1, 0};
  Edges edge = {0, 0.25f, -0.25f, 0};
  EXPECT_TRUE(limit_crowding({3, 1, 1}, depths.data() + 1, edge.data()));
  EXPECT_GE(edge[2] - edge[1], 0);
}

}  // namespace
}  // namespace pentimento::conservative
