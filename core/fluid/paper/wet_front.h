#pragma once
// How the wet front of a film advances. A bare cell has no velocity, so tracing it back leaves it
// bare, and R15 gives it no velocity either. To the letter of the rules no film would ever leave
// the cells that it lies on. The paper is silent on this. So thin cells take the velocity of the
// thick film that reaches them: a Neumann condition (A9) as wide as the way that the film travels
// in the step.

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Gives the velocity of a thick cell of row y to the thin cells of the row that it flows into
/// within this step. A front advances by n cells, at most to the next thick cell, if its foremost n
/// cells all travel at least n - 1 cells. So a film that slides moves as a whole, and a film that
/// spreads advances by one cell. A stamped cell advances nothing, for its velocity is that of the
/// brush.
void advance_front_along_row(const StepConstants& k, const CanvasState& state,
                             const BrushContact& contact, const Velocity& velocity, int y,
                             Columns cells, FrontInflow& inflow);

/// The same along the columns `cells`, in the rows [row_begin, row_end).
void advance_front_along_columns(const StepConstants& k, const CanvasState& state,
                                 const BrushContact& contact, const Velocity& velocity,
                                 Columns cells, int row_begin, int row_end, FrontInflow& inflow);

/// Whether a film reaches any of the cells of row y.
bool any_inflow(const FrontInflow& inflow, int y, Columns cells);

/// Forgets the films that reach the cells of row y.
void clear_inflow(int y, Columns cells, FrontInflow& inflow);

/// Writes the velocity that the step leaves in row y. Returns whether any bit changed.
///   thin cells (d < dry film) that films reach: the mean of the velocities of these films;
///   bare paper that no film reaches: 0; all other cells: their own velocity
/// Scheme: first-order extrapolation. Stable: a mean. Source: A9, R15. Departures: see above.
/// Stamped wet cells keep the brush's velocity (R17). The caller closes the edge (R16) in both.
bool update_velocity_row(const BrushContact& contact, const Velocity& velocity,
                         const FrontInflow& inflow, int y, Columns cells, CanvasState& state);

/// The same where no film reaches a cell.
bool update_velocity_row(const Velocity& velocity, int y, Columns cells, CanvasState& state);

}  // namespace pentimento::paper
