#include "core/detail/lock/block_ratios.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentimento {
namespace {

// Two tiles side by side, of 16 x 16 blocks, on a guide of 20 x 16.
const DetailLayout kLayout{{20, 16, 1, 1}, 8};

/// The ratio that a test gives to a block of a plane.
float made_up(std::size_t plane, int x, int y) {
  return 2 + static_cast<float>(plane) + 0.25f * static_cast<float>(x) +
         0.01f * static_cast<float>(y);
}

/// Lists the strips, in this order, and gives all their blocks ratios in two planes.
void give(const std::vector<BlockStrip>& strips, BlockRatios& ratios) {
  ratios.clear();
  for (const BlockStrip& strip : strips) ratios.add(strip);
  ratios.reset(2);
  for (std::size_t plane = 0; plane < 2; ++plane) {
    std::size_t first = 0;
    for (const BlockStrip& s : strips) {
      const auto count = static_cast<std::size_t>(s.blocks());
      const std::span<float> to = ratios.of(plane, first, count);
      for (std::size_t i = 0; i < count; ++i)
        to[i] = made_up(plane, s.x0 + static_cast<int>(i), s.y);
      first += count;
    }
  }
}

void expect_around(const BlockRatios& ratios, const BlockStrip& strip,
                   const std::vector<BlockStrip>& listed) {
  for (std::size_t plane = 0; plane < 2; ++plane) {
    RatiosAround found;
    ratios.read(plane, strip, found);
    for (int row = 0; row < 3; ++row)
      for (int block = -1; block <= strip.blocks(); ++block) {
        const int x = std::clamp(strip.x0 + block, 0, 19);
        const int y = std::clamp(strip.y + row - 1, 0, 15);
        float wanted = 1;
        for (const BlockStrip& s : listed)
          if (s.y == y && x >= s.x0 && x < s.x1) wanted = made_up(plane, x, y);
        EXPECT_EQ(found.at(row, block), wanted) << plane << ": " << x << ", " << y;
      }
  }
}

TEST(BlockRatios, AreReadWithTheirNeighboursOfOtherTilesToo) {
  const std::vector<BlockStrip> strips = {{0, 4, 3, 9},   {0, 5, 2, 16},  {0, 6, 10, 12},
                                          {1, 5, 16, 18}, {1, 6, 16, 20}, {1, 4, 17, 20}};
  BlockRatios ratios(kLayout);
  give(strips, ratios);
  EXPECT_EQ(ratios.blocks(), 31u);
  for (const BlockStrip& strip : strips) expect_around(ratios, strip, strips);
}

TEST(BlockRatios, OfTheOutermostBlocksGoOnBeyondTheGuide) {
  const std::vector<BlockStrip> strips = {
      {0, 0, 0, 16}, {1, 0, 16, 20}, {0, 15, 0, 3}, {1, 15, 19, 20}};
  BlockRatios ratios(kLayout);
  give(strips, ratios);
  for (const BlockStrip& strip : strips) expect_around(ratios, strip, strips);
}

TEST(BlockRatios, AreForgotten) {
  BlockRatios ratios(kLayout);
  give({{0, 4, 3, 9}, {0, 5, 2, 16}}, ratios);
  const std::vector<BlockStrip> others = {{0, 6, 4, 8}};
  give(others, ratios);
  EXPECT_EQ(ratios.blocks(), 4u);
  expect_around(ratios, others[0], others);
}

}  // namespace
}  // namespace pentimento
