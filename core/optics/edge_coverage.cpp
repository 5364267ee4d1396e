#include "core/optics/edge_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/base/check.h"

namespace pentimento {
namespace {

/// The least of 3 x 3 depths around each cell, for rows 1 to 3 of the five and one cell fewer at
/// each end.
std::array<std::vector<float>, 3> least_around(const CoverageRows& depth_m) {
  const std::size_t n = depth_m[0].size();
  std::array<std::vector<float>, 3> out;
  std::vector<float> column(n);
  for (std::size_t row = 0; row < out.size(); ++row) {
    for (std::size_t i = 0; i < n; ++i)
      column[i] = std::min(std::min(depth_m[row][i], depth_m[row + 1][i]), depth_m[row + 2][i]);
    out[row].resize(n - 2);
    for (std::size_t i = 0; i + 2 < n; ++i)
      out[row][i] = std::min(std::min(column[i], column[i + 1]), column[i + 2]);
  }
  return out;
}

/// The depth of the film whose edge runs through cell i of the row: D.
float full_depth(const CoverageRows& depth_m, const std::array<std::vector<float>, 3>& least,
                 std::size_t i) {
  float sum = 0, deepest = 0;
  int inner = 0;
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = i; column < i + 3; ++column) {
      const float depth = depth_m[row + 1][column + 1];
      deepest = std::max(deepest, depth);
      if (least[row][column] < kBareDepth_m) continue;
      sum += depth;
      ++inner;
    }
  }
  return inner > 0 ? sum / static_cast<float>(inner) : deepest;
}

}  // namespace

void edge_coverage_row(const CoverageRows& depth_m, std::span<float> coverage) {
  for (const std::vector<float>& row : depth_m)
    PENTIMENTO_CHECK(row.size() == coverage.size() + 2 * kCoverageReach);
  std::fill(coverage.begin(), coverage.end(), 1.0f);
  const std::array<std::vector<float>, 3> least = least_around(depth_m);
  for (std::size_t i = 0; i < coverage.size(); ++i) {
    const float depth = depth_m[kCoverageReach][i + kCoverageReach];
    if (depth < kBareDepth_m || least[1][i + 1] >= kBareDepth_m) continue;
    const float share = depth / full_depth(depth_m, least, i);
    coverage[i] = share < kEdgeRise / 2 ? std::sqrt(2 * kEdgeRise * share)
                                        : std::min(share + kEdgeRise / 2, 1.0f);
  }
}

}  // namespace pentimento
