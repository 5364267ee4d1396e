#pragma once
// Drying (R20): wet paint becomes part of the base.

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/paint_account.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/edge_coverage.h"

namespace pentimento {

/// The wet paint on the canvas: sums over the cells in the order of rows, times the area of a cell.
PaintFlow wet_paint(const CanvasState& state);

/// Dries the canvas: b += d, d = 0. The dry layer's reflectance becomes that of the wet layers over
/// it (R31, A40). Layers, stroke ids and velocities are cleared. `dried` grows by what was wet.
void dry_canvas(CanvasState& state, const ChannelBasis& basis, const Model& model, EdgeCells edges,
                const Threads& threads, PaintFlow& dried);

}  // namespace pentimento
