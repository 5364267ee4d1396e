#include "core/detail/store/block_layers.h"

#include <algorithm>

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

}  // namespace pentimento
