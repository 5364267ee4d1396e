#pragma once
// Which layer a stroke's pigment goes to (R26), and making room for it (R27).

#include <cstdint>

#include "core/layers/layer_row.h"

namespace pentimento {

/// Moves the layers of cell x down over empty ones, so that the occupied are 0 .. n-1 (A23).
/// Returns n.
int compact_layers(const LayerRow& row, int x);

/// R27: layer 1 is added to layer 0, layers 2.. move down one, the top is emptied. One layer alone
/// stays as it is.
void merge_bottom_layers(const LayerRow& row, int x);

/// The layer of cell x that takes the pigment of the stroke `stroke_id`, given that `last_id`
/// touched the cell last: the top one if that is the same stroke, else the lowest free one, for
/// which holes are closed and, if all are full, the bottom two merged. Sums per channel are kept.
/// Source: R26, R27. Departs from it: nothing; "free" is read as A23.
int open_layer(const LayerRow& row, int x, std::uint32_t stroke_id, std::uint32_t last_id);

}  // namespace pentimento
