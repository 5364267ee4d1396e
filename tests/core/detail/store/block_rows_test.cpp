#include "core/detail/store/block_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pentimento {
namespace {

constexpr int kStride = 140;

/// Fine cells of a row of blocks, all different.
std::vector<float> plane_of(int factor) {
  std::vector<float> plane(static_cast<std::size_t>(factor * kStride));
  for (std::size_t i = 0; i < plane.size(); ++i)
    plane[i] = 1 + static_cast<float>(i * 7919 % 101) / 101;
  return plane;
}

double plain_mean(const std::vector<float>& plane, int factor, int block) {
  double sum = 0;
  for (int y = 0; y < factor; ++y)
    for (int x = 0; x < factor; ++x)
      sum += static_cast<double>(plane[static_cast<std::size_t>(y * kStride + block * factor + x)]);
  return sum / (factor * factor);
}

/// The field at a position counted in guide cells from the centre of cell 0, repeated beyond.
double plain_field(const Field<float>& ratio, double x, double y) {
  const auto value = [&](int i, int j) {
    return static_cast<double>(
        ratio(std::clamp(i, 0, ratio.width() - 1), std::clamp(j, 0, ratio.height() - 1)));
  };
  const int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  const double u = x - i, v = y - j;
  return (1 - v) * ((1 - u) * value(i, j) + u * value(i + 1, j)) +
         v * ((1 - u) * value(i, j + 1) + u * value(i + 1, j + 1));
}

TEST(BlockMeans, AreTheMeansOfTheirCells) {
  for (const int k : {1, 2, 3, 8, 32}) {
    std::vector<float> plane = plane_of(k);
    std::vector<float> mean(4);
    block_means({plane.data(), kStride, k, 4}, mean);
    for (int b = 0; b < 4; ++b)  // sums of at most 32 floats: 16 roundings of 6e-8
      EXPECT_NEAR(static_cast<double>(mean[static_cast<std::size_t>(b)]), plain_mean(plane, k, b),
                  2e-6)
          << "k " << k << " block " << b;
  }
}

TEST(ScaleByField, IsBilinearBetweenCentres) {
  Field<float> ratio(6, 3, 1.0f);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 6; ++x) ratio(x, y) = 1 + 0.3f * static_cast<float>(x * x + 2 * y);
  for (const int k : {1, 2, 3, 8, 21}) {
    for (const int y : {0, 1, 2}) {
      for (const int x0 : {0, 1, 2}) {
        const std::vector<float> before = plane_of(k);
        std::vector<float> plane = before;
        std::vector<float> mean(4);
        RatiosAround around;
        read_around(ratio, {0, y, x0, x0 + 4}, around);
        scale_by_field(around.from(0), {plane.data(), kStride, k, 4}, mean);
        for (int j = 0; j < k; ++j) {
          for (int i = 0; i < 4 * k; ++i) {
            const auto at = static_cast<std::size_t>(j * kStride + i);
            const double field =
                plain_field(ratio, x0 + (i + 0.5) / k - 0.5, y + (j + 0.5) / k - 0.5);
            // A handful of roundings of values up to 22.
            ASSERT_NEAR(static_cast<double>(plane[at]), static_cast<double>(before[at]) * field,
                        2e-5)
                << "k " << k << " row " << y << " cell " << i << "," << j;
          }
        }
        EXPECT_NEAR(static_cast<double>(mean[2]), plain_mean(plane, k, 2), 2e-5);
      }
    }
  }
}

TEST(ScaleBlocks, ScalesEachBlockAlone) {
  std::vector<float> plane(16, 1.0f);
  const std::vector<float> scale = {1, 2};
  scale_blocks(scale, {plane.data(), 4, 2, 2});
  EXPECT_EQ(plane, (std::vector<float>{1, 1, 2, 2, 1, 1, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1}));
}

}  // namespace
}  // namespace pentimento
