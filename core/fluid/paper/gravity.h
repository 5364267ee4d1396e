#pragma once
// Gravity: what slope and tilt add to the velocity (R11, R15).

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Adds to the velocity of row y what the slope of the new height and the tilt of the tablet give.
///   u* = u~ - dt (1 - Phi) (gz h+_x + gx), likewise v; with A7 (b): u~ - dt ((1 - Phi) gz h+_x +
///   gx)
/// Scheme: central differences, 2nd order in space, 1st order in time. Stable with the implicit h+.
/// Source: R11, R15, A13 (Stuyck et al. 2016, equation 4). Departures: none beyond gz >= 0.
/// g is specific force: paint accelerates against it. Updates u_m_s[0] and v_m_s[0] in place.
void accelerate_row(const StepConstants& k, const CanvasState& state, const Field<float>& height_m,
                    int y, Columns cells, Planes& planes);

}  // namespace pentimento::paper
