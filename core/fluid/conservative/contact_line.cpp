#include "core/fluid/conservative/contact_line.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

constexpr float kBareFrac = 0.02f;  // of e: thinner films are bare canvas

// Whether any face of a row stands between a film and bare canvas.
PENTIMENTO_KERNEL
bool any_edge(const float* __restrict a, const float* __restrict b, int n, float bare) {
  int edges = 0;
  for (int i = 0; i < n; ++i) edges |= (a[i] > bare ? 1 : 0) ^ (b[i] > bare ? 1 : 0);
  return edges != 0;
}

// Marks those that do.
PENTIMENTO_KERNEL
void mark_edges(const float* __restrict a, const float* __restrict b, int n, float bare,
                std::uint8_t* __restrict edge) {
  for (int i = 0; i < n; ++i)
    edge[i] = static_cast<std::uint8_t>((a[i] > bare ? 1 : 0) ^ (b[i] > bare ? 1 : 0));
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
      if (row.weight.empty()) {
        row.x0 = i;
        row.weight.assign(static_cast<std::size_t>(i - row.first()), 0);
      }
      row.x1 = i;
      row.weight.push_back(inside > kLeast ? inside : kLeast);
      taps.total += row.weight.back();
    }
    if (row.weight.empty()) continue;
    row.weight.resize((row.weight.size() + kLanes - 1) / kLanes * kLanes, 0);
    taps.add(std::move(row));
  }
  return taps;
}

void ContactLine::ProfileTaps::add(TapRow taps) {
  x0 = std::min(x0, taps.first());
  x1 = std::max(x1, taps.first() + static_cast<int>(taps.weight.size()) - 1);
  y0 = std::min(y0, taps.y);
  y1 = std::max(y1, taps.y);
  row.push_back(std::move(taps));
}

// Sums in four lanes, so that additions need not wait for one another.
float ContactLine::mean_depth(const Field<float>& depth_m, const ProfileTaps& taps, int x, int y) {
  const bool all_inside = x + taps.x0 >= 0 && x + taps.x1 < depth_m.width() && y + taps.y0 >= 0 &&
                          y + taps.y1 < depth_m.height();
  if (!all_inside) return mean_depth_within(depth_m, taps, x, y);
  float lane[kLanes] = {0, 0, 0, 0};
  for (const TapRow& row : taps.row) {
    const float* depth = depth_m.row(y + row.y) + x + row.first();
    const float* weight = row.weight.data();
    for (std::size_t i = 0; i < row.weight.size(); i += kLanes)
      for (std::size_t k = 0; k < kLanes; ++k) lane[k] += weight[i + k] * depth[i + k];
  }
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) / taps.total;
}

// The same where the neighbourhood may reach beyond the canvas.
float ContactLine::mean_depth_within(const Field<float>& depth_m, const ProfileTaps& taps, int x,
                                     int y) {
  float lane[kLanes] = {0, 0, 0, 0};
  float beyond = 0;  // weight of what lies outside the canvas
  for (const TapRow& row : taps.row) {
    const bool outside = y + row.y < 0 || y + row.y >= depth_m.height();
    const int begin = outside ? row.x1 + 1 : std::max(row.x0, -x);
    const int end = outside ? begin : std::min(row.x1 + 1, depth_m.width() - x);
    const float* weight = row.weight.data() - row.first();
    for (int i = row.x0; i < begin; ++i) beyond += weight[i];
    for (int i = end; i <= row.x1; ++i) beyond += weight[i];
    if (begin >= end) continue;
    const float* depth = depth_m.row(y + row.y) + x;
    for (int i = begin; i < end; ++i) lane[i & (kLanes - 1)] += weight[i] * depth[i];
  }
  return ((lane[0] + lane[1]) + (lane[2] + lane[3])) / (taps.total - beyond);
}

void ContactLine::pin_row(const Field<float>& depth_m, Axis axis, int x, int y, int n,
                          float* friction_frac) const {
  constexpr int kAtOnce = 256;
  alignas(64) std::array<std::uint8_t, kAtOnce> edge;
  const float bare = kBareFrac * depth_m_;
  const ProfileTaps& taps = axis == Axis::kX ? taps_x_ : taps_y_;
  for (int begin = 0; begin < n; begin += kAtOnce) {
    const int end = std::min(begin + kAtOnce, n);
    const float* a = depth_m.row(y) + x + begin;
    const float* b = axis == Axis::kX ? a + 1 : depth_m.row(y + 1) + x + begin;
    // Most faces are no edge, and in most rows none is.
    if (!any_edge(a, b, end - begin, bare)) continue;
    mark_edges(a, b, end - begin, bare, edge.data());
    const auto next_edge = [&](int from) {
      const std::uint8_t* first = edge.data() + (from - begin);
      const void* found = std::memchr(first, 1, static_cast<std::size_t>(end - from));
      return found == nullptr
                 ? end
                 : from + static_cast<int>(static_cast<const std::uint8_t*>(found) - first);
    };
    for (int at = next_edge(begin); at < end; at = next_edge(at + 1)) {
      const float ratio = depth_m_ / (2 * mean_depth(depth_m, taps, x + at, y));
      const float free = 1 - ratio * ratio;
      friction_frac[at] *= free > 0 ? free : 0.0f;
    }
  }
}

}  // namespace pentimento::conservative
