#pragma once
// The implicit height equation (R6, R7).

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Builds the implicit equation for the height in row y, divided by its diagonal.
///   h+ + G dt^2 (b_x h+_x + b_y h+_y) - G dt^2 d (h+_xx + h+_yy) = h~ + dt (u~ b_x + v~ b_y)
///   - dt d (u~_x + v~_y), G = mobility gz
/// Scheme: central differences, 2nd order in space; implicit, 1st order in time. The step is stable
/// for any dt; the sweeps that solve it need a dominant diagonal, see the departure.
/// Source: R6, R7, R15 (Stuyck et al. 2016, equation 2).
/// Departures: the weight of b_x, G dt^2 b_x / 2 dx, is limited to the weight of d plus 1/4
/// (likewise b_y), which is just what keeps the diagonal dominant. The limit acts on thin films
/// over steep relief. Reads u_m_s[0], v_m_s[0] and the traced height in system.centre, which it
/// overwrites.
void build_height_system_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
                             Planes& planes);

}  // namespace pentimento::paper
