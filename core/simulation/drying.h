#pragma once
// R20: the wet paint dries. Also what a canvas is before anything is painted on it.

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/paint_account.h"
#include "core/model/model.h"
#include "core/optics/channels.h"

namespace pentimento {

/// What is wet on the canvas: sums over the cells in row order, times the cell's area.
PaintFlow wet_paint(const CanvasState& state);

/// b += d, d = 0; the dry layer's reflectance becomes that of the wet layers over it (R31); layers,
/// stroke ids and velocities are cleared. `dried` grows by what was wet.
void dry_canvas(CanvasState& state, const ChannelBasis& basis, const Model& model,
                const Threads& threads, PaintFlow& dried);

}  // namespace pentimento
