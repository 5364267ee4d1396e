#include "core/detail/flow/smooth_field.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

TEST(TileNeighbourhood, KeepsPlanes) {
  // A B-spline reproduces linear functions, at every fine centre.
  const int k = 5;
  TileNeighbourhood values({2, 6, 1, 4}, 20, 20);
  values.fill([](int x, int y) { return 3.0f * static_cast<float>(x) - static_cast<float>(y); });
  std::vector<float> out(20 * 15);
  values.smooth(k, out.data(), 20);
  // Beyond the canvas's upper edge values repeat, which bends the first two rows of cells.
  for (int y = 5; y < 15; ++y)
    for (int x = 0; x < 20; ++x)
      EXPECT_NEAR(out[static_cast<std::size_t>(y * 20 + x)],
                  3 * (2 + (x + 0.5f) / k - 0.5f) - (1 + (y + 0.5f) / k - 0.5f), 2e-5f);
}

TEST(TileNeighbourhood, StaysWithinItsValues) {
  const int k = 4;
  TileNeighbourhood values({0, 3, 0, 3}, 3, 3);
  values.fill([](int x, int y) { return (x + y) % 2 == 0 ? 1.0f : 0.0f; });
  std::vector<float> out(144);
  values.smooth(k, out.data(), 12);
  for (const float value : out) {
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
  }
}

TEST(TileNeighbourhood, GoesOnSmoothlyInTheNextTile) {
  const int k = 4;
  const auto hill = [](int x, int y) { return static_cast<float>((x * 7 + y * 5) % 11); };
  TileNeighbourhood left({0, 4, 0, 4}, 8, 4), both({0, 8, 0, 4}, 8, 4);
  left.fill(hill);
  both.fill(hill);
  std::vector<float> part(16 * 16), whole(32 * 16);
  left.smooth(k, part.data(), 16);
  both.smooth(k, whole.data(), 32);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      EXPECT_EQ(part[static_cast<std::size_t>(y * 16 + x)],
                whole[static_cast<std::size_t>(y * 32 + x)]);
}

}  // namespace
}  // namespace pentimento
