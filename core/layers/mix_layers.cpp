#include "core/layers/mix_layers.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"
#include "core/layers/cell_packet.h"

namespace pentimento {

namespace {
/// Exchange between the layers of one channel. `exchange[k]`: m between layers k and k + 1, 0 above
/// a cell's topmost layer; `most`: layers of the highest cell.
PENTIMENTO_KERNEL
void mix_channel(const LayerRow& row, int channel, int first, int cells, const PacketValues& mobile,
                 const std::array<PacketValues, kMaxLayers>& exchange, int most) {
  PacketValues below, incoming{};
  float* plane = &row.at(0, channel, first);
  for (int i = 0; i < cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    below[at] = mobile[at] * plane[i];
  }
  for (int k = 0; k + 1 < most; ++k) {
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
  float* top = &row.at(most - 1, channel, first);
  for (int i = 0; i < cells; ++i) top[i] += incoming[static_cast<std::size_t>(i)];
}

bool any_in_channel(const LayerRow& row, int channel, int first, int cells) {
  for (int layer = 0; layer < row.layers; ++layer)
    if (row.may_hold(layer, channel) && any_not_zero(&row.at(layer, channel, first), cells))
      return true;
  return false;
}

/// What may be exchanged in each cell of a block: m between layers below its topmost. `most`:
/// layers of the highest cell.
PENTIMENTO_KERNEL
void find_exchange(const MixLayers& mix, const PacketTotals& totals,
                   const std::array<int, kPacketCells>& occupied, int most, const float* weight,
                   int cells, float* __restrict mobile, std::array<PacketValues, kMaxLayers>& out) {
  const float residue = mix.residue, frac = mix.exchange_frac;
  const float* bottom = totals.total[0].data();
  for (int i = 0; i < cells; ++i) mobile[i] = free_share(bottom[i], residue);
  for (int k = 0; k + 1 < most; ++k) {
    float* __restrict exchange = out[static_cast<std::size_t>(k)].data();
    for (int i = 0; i < cells; ++i) {
      const float m = std::max(0.0f, std::min(0.5f, frac * weight[i]));
      exchange[i] = k + 1 < occupied[static_cast<std::size_t>(i)] ? m : 0.0f;
    }
  }
}

void mix_packet(const MixLayers& mix, const LayerRow& row, const float* weight, int first,
                int cells) {
  PacketTotals totals;
  totals.find(row, first, cells);
  std::array<int, kPacketCells> occupied;
  const int most = totals.find_occupied(row.layers, occupied);
  if (most < 2) return;
  PacketValues mobile;
  std::array<PacketValues, kMaxLayers> exchange;
  find_exchange(mix, totals, occupied, most, weight, cells, mobile.data(), exchange);
  if (!any_not_zero(exchange[0].data(), cells)) return;
  for (int c = 0; c < row.channels; ++c)
    if (any_in_channel(row, c, first, cells))
      mix_channel(row, c, first, cells, mobile, exchange, most);
}
}  // namespace

void mix_layers_row(const MixLayers& mix, const LayerRow& row, std::span<const float> weight) {
  if (row.layers < 2 || !(mix.exchange_frac > 0)) return;
  const int cells = static_cast<int>(weight.size());
  for (int first = 0; first < cells; first += kPacketCells)
    mix_packet(mix, row, weight.data() + first, first, std::min(kPacketCells, cells - first));
}

}  // namespace pentimento
