#pragma once
// Layers are opened for whole blocks, when the guide opens them in its cell: only so can the fine
// cells hold, layer by layer, what the guide's cell holds.

#include <array>
#include <cstdint>
#include <span>

#include "core/layers/layer_row.h"

namespace pentimento {

/// What open_layer() does to the layers of a cell.
struct LayerOpening {
  std::array<std::int8_t, kMaxLayers> to{};  // where each layer goes; itself if it stays
  bool merges = false;                       // then the bottom two become one
  int target = 0;                            // the layer that takes the stroke
};

/// The opening for a cell whose layers hold the amounts `total`, for a stroke that is new to it.
LayerOpening opening_of(std::span<const float> total);
/// The layer that takes more of the stroke that touched the cell last.
int layer_on_top(std::span<const float> total);
/// Does the same to a fine cell.
void open_fine(const LayerOpening& opening, const LayerRow& row, int x);

}  // namespace pentimento
