#include "core/detail/flow/profile_mean.h"

#include <cstddef>

#include "core/base/kernel.h"
#include "core/detail/flow/level_rows.h"
#include "core/detail/flow/smooth_field.h"

namespace pentimento {

namespace {
/// The four points along an axis of a cell.
constexpr std::array<SplineTaps, 4> kPoints = {spline_taps(-0.375f), spline_taps(-0.125f),
                                               spline_taps(0.125f), spline_taps(0.375f)};

/// Coverage at one of the four columns of points, in each of the five rows of cells.
using Column = std::array<std::array<float, kProfileBatch>, 2 * kProfileReach + 1>;

inline __attribute__((always_inline)) void find_column(const CoverageAround& coverage,
                                                       const SplineTaps& taps, int n,
                                                       Column& column) {
  const auto& w = taps.weight;
  for (std::size_t j = 0; j < column.size(); ++j) {
    const std::size_t first = 5 * j + static_cast<std::size_t>(taps.first + kProfileReach);
    const float *a = coverage[first].data(), *b = coverage[first + 1].data();
    const float *c = coverage[first + 2].data(), *d = coverage[first + 3].data();
    float* to = column[j].data();
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < n; ++i) to[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
  }
}
}  // namespace

PENTIMENTO_KERNEL
void profile_mean_row(const CoverageAround& coverage, int n, float* __restrict mean) {
  for (int i = 0; i < n; ++i) mean[i] = 0;
  Column column;
  for (const SplineTaps& across : kPoints) {
    find_column(coverage, across, n, column);
    for (const SplineTaps& down : kPoints) {
      const auto& w = down.weight;
      const auto first = static_cast<std::size_t>(down.first + kProfileReach);
      const float *a = column[first].data(), *b = column[first + 1].data();
      const float *c = column[first + 2].data(), *d = column[first + 3].data();
      PENTIMENTO_INDEPENDENT
      for (int i = 0; i < n; ++i)
        mean[i] += edge_profile(w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i]);
    }
  }
  for (int i = 0; i < n; ++i) mean[i] /= 16;
}

}  // namespace pentimento
