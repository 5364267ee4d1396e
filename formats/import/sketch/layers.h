#pragma once
// Layers of a recording become coats of paint.

#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// Orders the strokes by their layers, the lowest first, and lets each layer dry before the next
/// one. Within a layer the order stays. Nothing happens where all strokes are of one layer, or
/// where actions such as undo count on the order. Returns how many layers there are.
int paint_layer_by_layer(Sketch& sketch);

}  // namespace pentimento::sketch
