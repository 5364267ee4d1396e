#pragma once
// A detail canvas for a state that was painted without one.

#include "core/base/threads.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// Fills tiles where the guide has paint, wet or dry: each plane bilinear between the guide's cells
/// (an enlargement: there is no detail to be had), what has dried on top of the fine paper.
void prolong_guide(DetailCanvas& canvas, const CanvasState& guide, const Threads& threads);

}  // namespace pentimento
