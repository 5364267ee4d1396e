#include "core/layers/open_layer.h"

#include <algorithm>

namespace pentimento {

int compact_layers(const LayerRow& row, int x) {
  int occupied = 0;
  for (int layer = 0; layer < row.layers; ++layer) {
    if (!(row.total(layer, x) > kEmptyLayerAmount)) continue;
    if (layer != occupied) {
      for (int c = 0; c < row.channels; ++c) {
        // The layer below may count as empty and still hold a trace of pigment, so the amounts are
        // added to it.
        row.at(occupied, c, x) += row.at(layer, c, x);
        row.at(layer, c, x) = 0;
      }
    }
    ++occupied;
  }
  return occupied;
}

void merge_bottom_layers(const LayerRow& row, int x) {
  if (row.layers < 2) return;
  for (int c = 0; c < row.channels; ++c) {
    row.at(0, c, x) += row.at(1, c, x);
    for (int layer = 1; layer + 1 < row.layers; ++layer)
      row.at(layer, c, x) = row.at(layer + 1, c, x);
    row.at(row.layers - 1, c, x) = 0;
  }
}

int open_layer(const LayerRow& row, int x, std::uint32_t stroke_id, std::uint32_t last_id) {
  if (stroke_id == last_id) return std::max(0, row.top(x));
  const int occupied = compact_layers(row, x);
  if (occupied < row.layers) return occupied;
  merge_bottom_layers(row, x);
  return row.layers - 1;
}

}  // namespace pentimento
