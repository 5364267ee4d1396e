#pragma once
// What limits the velocity: the brush (R17), the edge of the canvas (R16), thresholds (R14).

#include <span>

#include "core/fluid/brush_contact.h"
#include "core/fluid/paper/grid_rows.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Where the brush touches row y, sets the velocity to that of the brush: a Dirichlet condition
/// wherever the footprint is not 0 (R17, A14). Does nothing in other rows.
void impose_brush_row(const BrushContact& contact, int y, Columns cells, float* u_m_s,
                      float* v_m_s);

/// Keeps paint from crossing the canvas's edge: sets the normal velocity of the edge cells to 0
/// (R16, A12).
void close_edge_row(int y, int width, int height, Columns cells, float* u_m_s, float* v_m_s);

/// Surface tension and the speed cap, pointwise.
///   (u,v) = 0 where |(u,v)| < threshold; |(u,v)| <= cap
/// Scheme: exact. Source: R14 (Stuyck et al. 2016, section 5.4). Departures: the cap, by default
/// 2 sqrt(g max_medium), twice the fastest wave of the deepest film: four sweeps do not converge,
/// and what they leave accelerates without bound where the film is thin or the tablet is shaken.
void limit_speed_row(const StepConstants& k, Columns cells, float* u_m_s, float* v_m_s);

}  // namespace pentimento::paper
