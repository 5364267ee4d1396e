#include "core/fluid/conservative/contact_line.h"

#include <algorithm>
#include <utility>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

constexpr float kBareFrac = 0.02f;  // of e: thinner films are bare canvas

// Whether any face of a row stands between a film and bare canvas: most rows have none.
PENTIMENTO_KERNEL
bool any_edge(const float* __restrict a, const float* __restrict b, int n, float bare) {
  int edges = 0;
  for (int i = 0; i < n; ++i) edges |= (a[i] > bare ? 1 : 0) ^ (b[i] > bare ? 1 : 0);
  return edges != 0;
}

}  // namespace

ContactLine::ContactLine(float depth_m, float reach_m, float dx_m, float dy_m)
    : depth_m_(depth_m),
      taps_x_(taps_around(0.5f, 0, reach_m, dx_m, dy_m)),
      taps_y_(taps_around(0, 0.5f, reach_m, dx_m, dy_m)) {}

ContactLine::ProfileTaps ContactLine::taps_around(float from_x, float from_y, float reach_m,
                                                  float dx_m, float dy_m) {
  // Coarse cells may all lie beyond reach: the two at the face count whatever their distance.
  constexpr float kLeast = 1e-3f;
  const int cells_x = static_cast<int>(reach_m / dx_m) + 1;
  const int cells_y = static_cast<int>(reach_m / dy_m) + 1;
  ProfileTaps taps;
  for (int j = -cells_y; j <= cells_y; ++j) {
    TapRow row{j, 0, -1, {}};
    for (int i = -cells_x; i <= cells_x; ++i) {
      const float x = static_cast<float>(i) - from_x;
      const float y = static_cast<float>(j) - from_y;
      const float across = x * (dx_m / reach_m);
      const float down = y * (dy_m / reach_m);
      const float inside = 1 - (across * across + down * down);
      const bool at_face = x * x <= from_x && y * y <= from_y;
      if (!(inside > kLeast || at_face)) continue;
      if (row.weight.empty()) row.x0 = i;
      row.x1 = i;
      row.weight.push_back(inside > kLeast ? inside : kLeast);
      taps.total += row.weight.back();
    }
    if (!row.weight.empty()) taps.row.push_back(std::move(row));
  }
  return taps;
}

// Sums in four lanes, so that additions need not wait for one another.
float ContactLine::mean_depth(const Field<float>& depth_m, const ProfileTaps& taps, int x, int y) {
  float lane[4] = {0, 0, 0, 0};
  float beyond = 0;  // weight of what lies outside the canvas
  for (const TapRow& row : taps.row) {
    const bool outside = y + row.y < 0 || y + row.y >= depth_m.height();
    const int begin = outside ? row.x1 + 1 : std::max(row.x0, -x);
    const int end = outside ? begin : std::min(row.x1 + 1, depth_m.width() - x);
    const float* weight = row.weight.data();
    for (int i = row.x0; i < begin; ++i) beyond += weight[i - row.x0];
    for (int i = end; i <= row.x1; ++i) beyond += weight[i - row.x0];
    if (begin >= end) continue;
    const float* depth = depth_m.row(y + row.y) + x;
    for (int i = begin; i < end; ++i) lane[i & 3] += weight[i - row.x0] * depth[i];
  }
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) / (taps.total - beyond);
}

void ContactLine::pin_row(const Field<float>& depth_m, Axis axis, int x, int y, int n,
                          float* friction_frac) const {
  const float bare = kBareFrac * depth_m_;
  const float* a = depth_m.row(y) + x;
  const float* b = axis == Axis::kX ? a + 1 : depth_m.row(y + 1) + x;
  if (!any_edge(a, b, n, bare)) return;
  const ProfileTaps& taps = axis == Axis::kX ? taps_x_ : taps_y_;
  for (int i = 0; i < n; ++i) {
    if ((a[i] > bare) == (b[i] > bare)) continue;
    const float ratio = depth_m_ / (2 * mean_depth(depth_m, taps, x + i, y));
    const float free = 1 - ratio * ratio;
    friction_frac[i] *= free > 0 ? free : 0.0f;
  }
}

}  // namespace pentimento::conservative
