#pragma once
#include "core/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// The velocity that the step leaves in row y; returns whether any bit changed.
///   thin cells (d < dry film): the mean velocity of the thicker neighbours that flow into them;
///   without such neighbours their own, and 0 on bare paper
/// Scheme: Neumann condition at the front of a film, one cell wide. Stable: a mean.
/// Source: A9, R15. Departures: the paper is silent. A bare cell has no velocity of its own and so
/// traces to itself, and R15 gives it none: read to the letter a film's front never moves and the
/// film dies behind it (tests). With this it moves by at most one cell per step.
/// Stamped wet cells keep the brush's velocity (R17). Reads the new depth and `u_m_s`, `v_m_s`.
bool update_velocity_row(const StepConstants& k, const BrushContact& contact,
                         const Field<float>& u_m_s, const Field<float>& v_m_s, int y, Columns cells,
                         CanvasState& state);

}  // namespace pentimento::paper
