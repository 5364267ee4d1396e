#include "core/layers/mix_layers.h"

#include <algorithm>

#include "core/fluid/conservative/kernel.h"
#include "core/layers/cell_block.h"

namespace pentimento {

namespace {
/// Exchange between the layers of one channel. `exchange[k]`: m between layers k and k + 1, 0 above
/// a cell's topmost layer.
PENTIMENTO_KERNEL
void mix_channel(const LayerRow& row, int channel, int first, int cells, const BlockValues& mobile,
                 const std::array<BlockValues, kMaxLayers>& exchange) {
  BlockValues below, incoming{};
  float* plane = &row.at(0, channel, first);
  for (int i = 0; i < cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    below[at] = mobile[at] * plane[i];
  }
  for (int k = 0; k + 1 < row.layers; ++k) {
    float* lower = &row.at(k, channel, first);
    const float* upper = &row.at(k + 1, channel, first);
    for (int i = 0; i < cells; ++i) {
      const std::size_t at = static_cast<std::size_t>(i);
      const float outgoing = exchange[static_cast<std::size_t>(k)][at] * (below[at] - upper[i]);
      lower[i] += incoming[at] - outgoing;
      incoming[at] = outgoing;
      below[at] = upper[i];
    }
  }
  float* top = &row.at(row.layers - 1, channel, first);
  for (int i = 0; i < cells; ++i) top[i] += incoming[static_cast<std::size_t>(i)];
}

bool any_in_channel(const LayerRow& row, int channel, int first, int cells) {
  for (int layer = 0; layer < row.layers; ++layer)
    if (any_paint(&row.at(layer, channel, first), cells)) return true;
  return false;
}

void mix_block(const MixLayers& mix, const LayerRow& row, const float* weight, int first,
               int cells) {
  BlockTotals totals;
  totals.find(row, first, cells);
  BlockValues mobile;
  std::array<BlockValues, kMaxLayers> exchange;
  bool any = false;
  for (int i = 0; i < cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const float m = std::max(0.0f, std::min(0.5f, mix.exchange_frac * weight[i]));
    const int top = totals.top(row.layers, i);
    mobile[at] = mobile_share(totals.total[0][at], mix.residue);
    for (int k = 0; k + 1 < row.layers; ++k)
      exchange[static_cast<std::size_t>(k)][at] = k < top ? m : 0.0f;
    any |= m > 0 && top > 0;
  }
  if (!any) return;
  for (int c = 0; c < row.channels; ++c)
    if (any_in_channel(row, c, first, cells)) mix_channel(row, c, first, cells, mobile, exchange);
}
}  // namespace

void mix_layers_row(const MixLayers& mix, const LayerRow& row, std::span<const float> weight) {
  if (row.layers < 2 || !(mix.exchange_frac > 0)) return;
  const int cells = static_cast<int>(weight.size());
  for (int first = 0; first < cells; first += kBlockCells)
    mix_block(mix, row, weight.data() + first, first, std::min(kBlockCells, cells - first));
}

}  // namespace pentimento
