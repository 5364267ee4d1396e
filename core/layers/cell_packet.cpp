#include "core/layers/cell_packet.h"

#include "core/base/kernel.h"

namespace pentimento {

namespace {
PENTIMENTO_KERNEL
void add_weighted(float weight, const float* plane, int cells, float* __restrict sum) {
  for (int i = 0; i < cells; ++i) sum[i] += weight * plane[i];
}

PENTIMENTO_KERNEL
void raise_where_held(const float* total, int cells, int layer, int* __restrict occupied) {
  for (int i = 0; i < cells; ++i)
    occupied[i] = total[i] > kEmptyLayerAmount ? layer + 1 : occupied[i];
}

PENTIMENTO_KERNEL
int most_of(const int* values, int n) {
  // From the first value on, for vectors that were just written are read as they were written.
  int most = values[0];
  for (int i = 0; i < n; ++i) most = values[i] > most ? values[i] : most;
  return most;
}
}  // namespace

void PacketTotals::find(const LayerRow& row, int first, int cells) {
  count = cells;
  for (int layer = 0; layer < row.layers; ++layer) {
    PacketValues& sum = total[static_cast<std::size_t>(layer)];
    std::fill_n(sum.begin(), cells, 0.0f);
    for (int c = 0; c < row.channels; ++c) {
      const float m = row.amount[static_cast<std::size_t>(c)];
      if (m != 0 && row.may_hold(layer, c))
        add_weighted(m, &row.at(layer, c, first), cells, sum.data());
    }
  }
}

int PacketTotals::find_occupied(int layers, std::array<int, kPacketCells>& occupied) const {
  std::fill_n(occupied.begin(), count, 0);
  for (int layer = 0; layer < layers; ++layer)
    raise_where_held(total[static_cast<std::size_t>(layer)].data(), count, layer, occupied.data());
  return most_of(occupied.data(), count);
}

}  // namespace pentimento
