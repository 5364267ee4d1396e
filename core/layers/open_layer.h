#pragma once
// Opening a layer: which layer the pigment of a stroke goes to (R26), and how room is made for it
// (R27).

#include <cstdint>

#include "core/layers/layer_row.h"

namespace pentimento {

/// Moves the layers of cell x down over empty layers, so that layers 0 .. n-1 hold pigment and no
/// others do (A23). Returns n.
int compact_layers(const LayerRow& row, int x);

/// R27: adds layer 1 to layer 0, moves the layers from 2 on down by one and empties the top layer.
/// A cell of one layer stays as it is.
void merge_bottom_layers(const LayerRow& row, int x);

/// The layer of cell x that takes the pigment of stroke `stroke_id`, if stroke `last_id` touched
/// the cell last. The same stroke goes on in its top layer. Another stroke takes the lowest free
/// layer: empty layers below are closed first, and if all layers are full, the bottom two are
/// merged. Sums per channel stay. Source: R26, R27. Departs from it: nothing; "free" is read as
/// A23.
int open_layer(const LayerRow& row, int x, std::uint32_t stroke_id, std::uint32_t last_id);

}  // namespace pentimento
