#include "core/detail/store/block_layers.h"

#include <algorithm>

#include "core/layers/open_layer.h"

namespace pentimento {

LayerOpening opening_of(std::span<const float> total) {
  const int layers = static_cast<int>(total.size());
  LayerOpening opening;
  int occupied = 0;
  for (std::size_t layer = 0; layer < total.size(); ++layer) {
    const bool holds = total[layer] > kEmptyLayerAmount;
    opening.to[layer] = static_cast<std::int8_t>(holds ? occupied++ : static_cast<int>(layer));
  }
  opening.merges = occupied == layers;
  opening.target = std::min(occupied, layers - 1);
  return opening;
}

int layer_on_top(std::span<const float> total) {
  for (std::size_t layer = total.size(); layer-- > 0;)
    if (total[layer] > kEmptyLayerAmount) return static_cast<int>(layer);
  return 0;
}

void open_fine(const LayerOpening& opening, const LayerRow& row, int x) {
  for (int layer = 0; layer < row.layers; ++layer) {
    const int to = opening.to[static_cast<std::size_t>(layer)];
    if (to == layer) continue;
    for (int c = 0; c < row.channels; ++c) {
      row.at(to, c, x) += row.at(layer, c, x);
      row.at(layer, c, x) = 0;
    }
  }
  if (opening.merges) merge_bottom_layers(row, x);
}

}  // namespace pentimento
