#pragma once
// How the front of a film gets on. A bare cell has no velocity, so traced back it stays bare, and
// R15 gives it none: read to the letter no film ever leaves the cells it lies on, and what moves
// dies at its front. The paper is silent; so thin cells take the velocity of the thick film that
// reaches them, a Neumann condition (A9) as wide as the film travels in the step.

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Thin cells of row y that a thick one in the same row flows into within this step: they receive
/// its velocity. A front advances by n cells, up to the next thick one, if its foremost n cells all
/// travel at least n - 1: a film that slides moves as a whole, one that spreads goes one cell. A
/// stamped cell advances nothing, for its velocity is the brush's, not the film's.
void advance_front_along_row(const StepConstants& k, const CanvasState& state,
                             const BrushContact& contact, const Velocity& velocity, int y,
                             Columns cells, FrontInflow& inflow);

/// The same along the columns `cells`, from rows [row_begin, row_end).
void advance_front_along_columns(const StepConstants& k, const CanvasState& state,
                                 const BrushContact& contact, const Velocity& velocity,
                                 Columns cells, int row_begin, int row_end, FrontInflow& inflow);

/// The velocity that the step leaves in row y; returns whether any bit changed.
///   thin cells (d < dry film): the mean of what reaches them; else, and in all other cells, their
///   own; 0 on bare paper that nothing reaches
/// Scheme: first-order extrapolation. Stable: a mean. Source: A9, R15. Departures: see above.
/// Stamped wet cells keep the brush's velocity (R17). The caller closes the edge (R16) in both.
bool update_velocity_row(const BrushContact& contact, const Velocity& velocity,
                         const FrontInflow& inflow, int y, Columns cells, CanvasState& state);

}  // namespace pentimento::paper
