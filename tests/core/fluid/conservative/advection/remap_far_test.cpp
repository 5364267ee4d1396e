#include "core/fluid/conservative/advection/remap_far.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

// Where one far cell lands in a line of eight cells.
std::array<float, 8> landed(const FarCell& cell) {
  std::array<float, 8> line{};
  put_far_cells({cell}, {8}, rounder_for(0x1p-24f),
                [&](int at, int) -> float& { return line[static_cast<std::size_t>(at)]; });
  return line;
}

TEST(RemapFar, TheProfileIsStretchedOverTheImage) {
  // Cell 1 goes to [3, 6]: the share below t of 1 + (t - 1/2) is (t + t^2) / 2.
  const std::array<float, 8> line = landed({1, 0, 2, 4, 1, 1});
  const float rounding = 0x1p-23f;  // one quantum and the sum's
  EXPECT_NEAR(line[3], 2.0f / 9, rounding);
  EXPECT_NEAR(line[4], 3.0f / 9, rounding);
  EXPECT_NEAR(line[5], 4.0f / 9, rounding);
  EXPECT_EQ(line[2] + line[6], 0.0f);
}

TEST(RemapFar, WhatOvertakesItselfComesOutTheOtherWayRound) {
  // The lower edge of cell 2 goes to 5, the upper one to 2: more of its paint lies near the latter.
  const std::array<float, 8> line = landed({2, 0, 3, -1, 1, 1});
  const float rounding = 0x1p-23f;
  EXPECT_NEAR(line[2], 4.0f / 9, rounding);
  EXPECT_NEAR(line[3], 3.0f / 9, rounding);
  EXPECT_NEAR(line[4], 2.0f / 9, rounding);
}

TEST(RemapFar, ALineInsideOfALongerOneGetsTheSameParts) {
  const FarCell cell{1, 0, 2.3f, 3.9f, 0.7f, 0.1f};
  const FarCell in_the_longer{1001, 0, 2.3f, 3.9f, 0.7f, 0.1f};
  std::array<float, 1008> longer{};
  std::array<float, 8> line{};
  const float rounder = rounder_for(0x1p-24f);
  put_far_cells({in_the_longer}, {1008}, rounder,
                [&](int at, int) -> float& { return longer[static_cast<std::size_t>(at)]; });
  put_far_cells({cell}, {8, 1000}, rounder,
                [&](int at, int) -> float& { return line[static_cast<std::size_t>(at)]; });
  EXPECT_TRUE(std::equal(line.begin(), line.end(), longer.begin() + 1000));
  EXPECT_NE(line, landed(cell));  // which counts from its own beginning, and rounds less
}

TEST(RemapFar, NothingLeavesTheLine) {
  for (const float way : {-20.0f, 20.0f}) {
    const std::array<float, 8> line = landed({4, 0, way, way, 0.5f, 0.25f});
    EXPECT_EQ(line[way < 0 ? 0 : 7], 0.5f);
  }
}

}  // namespace
}  // namespace pentimento::conservative
