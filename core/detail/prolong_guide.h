#pragma once
// Makes a detail canvas for a state that was painted without one.

#include "core/base/threads.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// Fills the tiles where the guide has paint, wet or dry. Each plane is bilinear between the
/// guide's cells: an enlargement, for there is no detail to be had. Dried paint lies on top of the
/// fine relief of the paper.
void prolong_guide(DetailCanvas& canvas, const CanvasState& guide, const Threads& threads);

}  // namespace pentimento
