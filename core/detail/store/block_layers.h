#pragma once
// Opening a layer in the fine cells of a block, as the guide opened it in its cell. The guide
// decides once for the whole block, and each fine cell does the same when the tip touches it
// (open_cells.h). So the fine cells hold, layer by layer, what the guide's cell holds.

#include <array>
#include <cstdint>
#include <span>

#include "core/layers/layer_row.h"

namespace pentimento {

/// What open_layer() does to the layers of a cell.
struct LayerOpening {
  std::array<std::int8_t, kMaxLayers> to{};  // where each layer goes; itself if it stays
  bool merges = false;                       // whether the bottom two layers become one
  int target = 0;                            // the layer that takes the stroke
  bool operator==(const LayerOpening&) const = default;
};

/// The opening for a stroke that is new to a cell. `total`: the amount in each of the cell's
/// layers.
LayerOpening opening_of(std::span<const float> total);
/// The layer that takes the paint of the stroke that touched the cell last: it goes on in its
/// layer.
int layer_on_top(std::span<const float> total);

}  // namespace pentimento
