#include "core/detail/flow/way_to_bare.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace pentimento {
namespace {

constexpr float kBareTo_m = 1e-6f;

/// The chamfer distance by its definition: of any way over cells side by side (3) and across (4)
/// the shortest. From one bare cell to another cell, over an open grid, it goes across as far as it
/// can.
int chamfer(int dx, int dy) {
  const int least = std::min(std::abs(dx), std::abs(dy));
  const int most = std::max(std::abs(dx), std::abs(dy));
  return 4 * least + 3 * (most - least);
}

Field<int> plain_way(const Field<float>& depth_m, int far) {
  Field<int> way(depth_m.width(), depth_m.height(), far);
  for (int v = 0; v < way.height(); ++v)
    for (int u = 0; u < way.width(); ++u) {
      if (depth_m(u, v) > kBareTo_m) continue;
      for (int y = 0; y < way.height(); ++y)
        for (int x = 0; x < way.width(); ++x)
          way(x, y) = std::min(way(x, y), chamfer(x - u, y - v));
    }
  return way;
}

void expect_same(const Field<float>& depth_m, int far) {
  const Field<int> found = way_to_bare(depth_m, kBareTo_m, far), plain = plain_way(depth_m, far);
  for (int y = 0; y < plain.height(); ++y)
    for (int x = 0; x < plain.width(); ++x) ASSERT_EQ(found(x, y), plain(x, y)) << x << ' ' << y;
}

TEST(WayToBare, IsTheShortestToAnyBareCell) {
  std::mt19937 random(1);
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {47, 31}, {33, 50}})
    for (const unsigned bare_of_thousand : {2u, 30u, 500u}) {
      Field<float> depth_m(width, height, 1e-4f);
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          if (random() % 1000 < bare_of_thousand) depth_m(x, y) = kBareTo_m;
      expect_same(depth_m, 1000);
      expect_same(depth_m, 24);
    }
}

TEST(WayToBare, OneBareCellIsSeenFromEverywhere) {
  for (const auto& [u, v] : {std::pair{0, 0}, {40, 0}, {0, 20}, {40, 20}, {1, 19}, {17, 9}}) {
    Field<float> depth_m(41, 21, 1e-4f);
    depth_m(u, v) = 0;
    expect_same(depth_m, 1000);
  }
}

TEST(WayToBare, WhereNothingIsBareAllIsFar) {
  const Field<int> way = way_to_bare(Field<float>(20, 10, 1e-4f), kBareTo_m, 24);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) EXPECT_EQ(way(x, y), 24);
}

}  // namespace
}  // namespace pentimento
