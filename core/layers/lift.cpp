#include "core/layers/lift.h"

#include <algorithm>

namespace pentimento {

namespace {
/// Share of the bottom layer that may leave the paper.
float mobile_share(const LayerRow& row, int x, float residue) {
  const float total = row.total(0, x);
  return total > residue ? (total - residue) / total : 0.0f;
}

/// Less than this is lifted whole, before it fades into subnormal numbers, which are slow.
constexpr float kTrace = 1e-20f;

/// Takes `share` of `value`, into `taken` and, exactly, into `sum`.
void take(float share, float& value, float& taken, double& sum) {
  const float rest = value - share * value;
  const float left = rest < kTrace ? 0 : rest;
  taken += value - left;
  sum += static_cast<double>(value) - static_cast<double>(left);
  value = left;
}

void lift_cell(const Lift& lift, const LayerRow& row, int x, float share, float& depth_m,
               float* lifted, std::span<double> sums) {
  const int occupied = row.top(x) + 1;
  float depth_weight = occupied == 0 ? 1.0f : 0.0f;
  for (int layer = 0; layer < occupied; ++layer) {
    const float reach = reach_weight(lift.reach_frac, layer, occupied);
    depth_weight += reach / static_cast<float>(occupied);
    const float part = share * reach * (layer == 0 ? mobile_share(row, x, lift.residue) : 1.0f);
    if (part == 0) continue;
    for (int c = 0; c < row.channels; ++c)
      take(part, row.at(layer, c, x), lifted[1 + c], sums[static_cast<std::size_t>(1 + c)]);
  }
  take(share * std::min(depth_weight, 1.0f), depth_m, lifted[0], sums[0]);
}
}  // namespace

float reach_weight(float reach_frac, int layer, int occupied) {
  if (reach_frac < 0) return 1;
  const int from_top = occupied - 1 - layer;
  return std::clamp(reach_frac * static_cast<float>(occupied) - static_cast<float>(from_top), 0.0f,
                    1.0f);
}

void lift_row(const Lift& lift, const LayerRow& row, std::span<const float> weight, float* depth_m,
              float* lifted, int stride, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t i = 0; i < weight.size(); ++i) {
    float* out = lifted + static_cast<std::ptrdiff_t>(i) * stride;
    std::fill_n(out, stride, 0.0f);
    const float share = std::min(1.0f, lift.share_frac * weight[i]);
    if (share > 0) lift_cell(lift, row, static_cast<int>(i), share, depth_m[i], out, sums);
  }
}

}  // namespace pentimento
