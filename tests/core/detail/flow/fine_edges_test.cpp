#include "core/detail/flow/fine_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace pentimento {
namespace {

std::vector<float> placed(const std::vector<float>& guide, int factor) {
  std::vector<float> position((guide.size() - 1) * static_cast<std::size_t>(factor) + 1);
  place_edges(guide, factor, position);
  return position;
}

TEST(BlendEdges, IsLinearAcrossAndSaysWhetherAnythingMoves) {
  const std::vector<float> a = {0, 1, 0}, b = {0, 3, 0};
  std::vector<float> out(3);
  EXPECT_TRUE(blend_edges(a, b, 0.25f, out));
  EXPECT_FLOAT_EQ(out[1], 1.5f);
  const std::vector<float> still = {0, 0, 0};
  EXPECT_FALSE(blend_edges(still, still, 0.5f, out));
}

TEST(PlaceEdges, KeepsTheGuidesEdgesWhereTheyWent) {
  const std::vector<float> guide = {0, 0.2f, 0.5f, 0.3f, 0};
  const std::vector<float> position = placed(guide, 8);
  for (std::size_t g = 0; g < guide.size(); ++g)
    EXPECT_NEAR(position[g * 8], static_cast<float>(g * 8) + 8 * guide[g],
                1e-5f);  // rounding of 32
}

TEST(PlaceEdges, StretchesWithoutJumpsBetweenBlocks) {
  const std::vector<float> guide = {0, 0.1f, 0.3f, 0.4f, 0.3f, 0.1f, 0};
  const int k = 32;
  const std::vector<float> position = placed(guide, k);
  // The cubic's second difference over 1/32 of a block is below 6/32^2 of the largest rise (0.2
  // blocks = 6.4 cells); straight pieces would jump by the change of rise, 0.2 at once.
  for (std::size_t e = 1; e + 1 < position.size(); ++e) {
    const float bend = position[e + 1] - 2 * position[e] + position[e - 1];
    EXPECT_LT(bend < 0 ? -bend : bend, 0.04f) << "edge " << e;
  }
}

TEST(PlaceEdges, StaysInsideTheWallsAndInOrder) {
  const std::vector<float> guide = {0, 5, -7, 3, 9, 0};
  const std::vector<float> position = placed(guide, 4);
  EXPECT_EQ(position.front(), 0);
  EXPECT_EQ(position.back(), 20);
  for (std::size_t e = 0; e + 1 < position.size(); ++e) EXPECT_LT(position[e], position[e + 1]);
}

TEST(PlaceEdges, LeavesStandingBlocksAlone) {
  const std::vector<float> position = placed({0, 0, 0, 0.5f, 0}, 4);
  for (std::size_t e = 0; e <= 8; ++e) EXPECT_EQ(position[e], static_cast<float>(e));
}

TEST(PlaceEdges, IsAHermiteCubicWithTheLimitedSlopesAtBothEnds) {
  // Between 0.1 and 0.3 with slopes 0.15 and 0.25: (0.1 + 0.3) / 2 + (0.15 - 0.25) / 8 half way.
  const std::array<float, 6> guide = {0, 0.1f, 0.3f, 0.6f, 0.5f, 0};
  std::array<float, 11> position{};
  place_edges(guide, 2, position);
  EXPECT_NEAR(position[2], 2 + 2 * 0.1, 1e-6);
  EXPECT_NEAR(position[3], 3 + 2 * 0.1875, 1e-6);
  EXPECT_NEAR(position[4], 4 + 2 * 0.3, 1e-6);
}

TEST(PlaceEdges, LinesThatNeedNoPushingAreToTheBitAsIfTheyWerePushed) {
  // Both passes over positions that were placed change nothing, whatever the guide: neither those
  // that needed the passes nor those that were spared them. Rises of 0.99 leave less than a sliver
  // in some lines and just a sliver in others.
  for (int seed = 0; seed < 400; ++seed) {
    std::vector<float> guide(9, 0.0f);
    for (std::size_t g = 1; g + 1 < guide.size(); ++g)
      guide[g] = 0.99f * static_cast<float>((static_cast<int>(g) * 37 + seed * 11) % 23 - 11) /
                 (seed % 2 == 0 ? 11.0f : 23.0f);
    const std::vector<float> position = placed(guide, 8);
    std::vector<float> pushed = position;
    for (std::size_t e = 1; e < pushed.size(); ++e)
      pushed[e] = std::max(pushed[e], pushed[e - 1] + 1.0f / 64);
    pushed.back() = 64;
    for (std::size_t e = pushed.size() - 1; e-- > 0;)
      pushed[e] = std::min(pushed[e], pushed[e + 1] - 1.0f / 64);
    pushed.front() = 0;
    EXPECT_EQ(position, pushed) << seed;
  }
}

}  // namespace
}  // namespace pentimento
