#pragma once
// Advection of velocity and height, by tracing backwards (R8).

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/grid_rows.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

struct TracedRow {
  float* u_m_s;
  float* v_m_s;
  float* height_m;
  Field<float>& mobility_frac;  // in and out
};

/// Finds velocity and height at the point where the fluid of each cell of row y was one step ago.
///   q~(x) = q(x - dt u(x)) for q = u, v, h
/// Scheme: semi-Lagrangian, one backward Euler trace, bilinear; 1st order. Stable for any step.
/// Source: R8; Stam, Stable Fluids, SIGGRAPH 1999, section 2.2, as Stuyck et al. 2016, section 5.1.
/// Departures: a bare cell whose departure point is bare is left alone (velocity 0, h = b), or the
/// relief itself would be carried about and become paint. A thin cell that a thick film enters
/// takes over the mobility of that film. Else the front of a film would not feel the gravity (R15)
/// that drives the film, and the film would run over its front.
void trace_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
               const TracedRow& out);

/// The plain way to do the same, cell by cell. trace_row() uses it for cells at the canvas's edge,
/// and where neighbours come from cells that are not (near_departures.h).
void trace_cells(const StepConstants& k, const CanvasState& state, int y, Columns cells,
                 const TracedRow& out);

}  // namespace pentimento::paper
