#pragma once
// Rounds what the brush left on the canvas to whole quanta (quantum.h), and a state that came from
// elsewhere.

#include "core/canvas/canvas_state.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

/// The cells that a step rounds: the smallest box around what the brush touched.
CellBox rounded_box(const BrushContact& contact);

/// Rounds depth and pigments to quanta where the brush touched, or everywhere at the first step
/// after the state came from elsewhere. What rounding takes from a cell is carried to the next wet
/// cell of the plane, in the order of rows. So the total of a plane changes by at most half a
/// quantum, and dry cells stay dry.
void round_to_quanta(CanvasState& state, const StepInput& in);

}  // namespace pentimento::conservative
