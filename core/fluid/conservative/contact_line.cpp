#include "core/fluid/conservative/contact_line.h"

#include "core/fluid/conservative/kernel.h"

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

std::vector<ContactLine::Tap> ContactLine::taps_around(float from_x, float from_y, float reach_m,
                                                       float dx_m, float dy_m) {
  // Coarse cells may all lie beyond reach: the two at the face count whatever their distance.
  constexpr float kLeast = 1e-3f;
  const int cells_x = static_cast<int>(reach_m / dx_m) + 1;
  const int cells_y = static_cast<int>(reach_m / dy_m) + 1;
  std::vector<Tap> taps;
  for (int j = -cells_y; j <= cells_y; ++j)
    for (int i = -cells_x; i <= cells_x; ++i) {
      const float x = static_cast<float>(i) - from_x;
      const float y = static_cast<float>(j) - from_y;
      const float across = x * (dx_m / reach_m);
      const float down = y * (dy_m / reach_m);
      const float inside = 1 - (across * across + down * down);
      const bool at_face = x * x <= from_x && y * y <= from_y;
      if (inside > kLeast || at_face) taps.push_back({i, j, inside > kLeast ? inside : kLeast});
    }
  return taps;
}

float ContactLine::mean_depth(const Field<float>& depth_m, const std::vector<Tap>& taps, int x,
                              int y) {
  float sum = 0;
  float weights = 0;
  for (const Tap& t : taps) {
    const int i = x + t.x;
    const int j = y + t.y;
    if (i < 0 || j < 0 || i >= depth_m.width() || j >= depth_m.height()) continue;
    sum += t.weight * depth_m.row(j)[i];
    weights += t.weight;
  }
  return sum / weights;
}

void ContactLine::hold_row(const Field<float>& depth_m, Axis axis, int x, int y, int n,
                           float* friction_frac) const {
  const float bare = kBareFrac * depth_m_;
  const float* a = depth_m.row(y) + x;
  const float* b = axis == Axis::kX ? a + 1 : depth_m.row(y + 1) + x;
  if (!any_edge(a, b, n, bare)) return;
  const std::vector<Tap>& taps = axis == Axis::kX ? taps_x_ : taps_y_;
  for (int i = 0; i < n; ++i) {
    if ((a[i] > bare) == (b[i] > bare)) continue;
    const float ratio = depth_m_ / (2 * mean_depth(depth_m, taps, x + i, y));
    const float free = 1 - ratio * ratio;
    friction_frac[i] *= free > 0 ? free : 0.0f;
  }
}

}  // namespace pentimento::conservative
