#include "core/detail/flow/profile_mean.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "core/detail/flow/level_rows.h"
#include "core/detail/flow/smooth_field.h"

namespace pentimento {
namespace {

/// The same, point by point, from the whole spline at a factor of four.
float plain_mean(const CoverageAround& coverage, std::size_t cell) {
  constexpr CellBox kMiddle = {2, 3, 2, 3};
  TileNeighbourhood around(kMiddle, 5, 5);
  around.fill([&](int x, int y) { return coverage[static_cast<std::size_t>(5 * y + x)][cell]; });
  float wet[16], sum = 0;
  around.smooth(4, wet, 4);
  for (const float w : wet) sum += edge_profile(w);
  return sum / 16;
}

TEST(ProfileMean, IsTheMeanOverPointsOfTheSpline) {
  CoverageAround coverage{};
  for (std::size_t k = 0; k < coverage.size(); ++k)
    for (std::size_t cell = 0; cell < kProfileBatch; ++cell)
      coverage[k][cell] = static_cast<float>((k * 7 + cell * 11 + k * cell) % 13) / 12;
  for (const int n : {1, 7, kProfileBatch}) {
    float mean[kProfileBatch];
    profile_mean_row(coverage, n, mean);
    // Sixteen terms, added in another order.
    for (int i = 0; i < n; ++i)
      EXPECT_NEAR(mean[i], plain_mean(coverage, static_cast<std::size_t>(i)), 1e-6f)
          << n << ' ' << i;
  }
}

TEST(ProfileMean, EndsAreWholeAndNothing) {
  CoverageAround coverage{};
  for (auto& row : coverage) row[1] = 1;
  float mean[2];
  profile_mean_row(coverage, 2, mean);
  EXPECT_EQ(mean[0], 0);
  EXPECT_FLOAT_EQ(mean[1], 1);
}

}  // namespace
}  // namespace pentimento
