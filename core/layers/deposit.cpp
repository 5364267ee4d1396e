#include "core/layers/deposit.h"

#include <algorithm>

#include "core/layers/open_layer.h"

namespace pentimento {

namespace {
void give(float amount, float& value, double& sum) {
  const float after = value + amount;
  sum += static_cast<double>(after) - static_cast<double>(value);
  value = after;
}

bool is_empty(const float* paint, int channels) {
  for (int i = 0; i <= channels; ++i)
    if (paint[i] > 0) return false;
  return true;
}
}  // namespace

void deposit_row(const Deposit& deposit, const LayerRow& row, std::span<float> depth_m,
                 std::uint32_t* stroke, float* paint, int stride, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const int x = static_cast<int>(i);
    float* p = paint + static_cast<std::ptrdiff_t>(i) * stride;
    if (is_empty(p, row.channels)) continue;
    const float room_m = std::max(0.0f, deposit.max_depth_m - depth_m[i]);
    if (p[0] > room_m) {
      const float fits = room_m / p[0];
      for (int k = 0; k <= row.channels; ++k) p[k] *= fits;
    }
    const int layer = open_layer(row, x, deposit.stroke_id, stroke[i]);
    for (int c = 0; c < row.channels; ++c)
      give(p[1 + c], row.at(layer, c, x), sums[static_cast<std::size_t>(1 + c)]);
    give(p[0], depth_m[i], sums[0]);
    stroke[i] = deposit.stroke_id;
  }
}

}  // namespace pentimento
