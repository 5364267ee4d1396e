#pragma once
// From the new height to the new depth (R1, R6), and which cells moved at all.

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"

namespace pentimento::paper {

/// Marks the cells of row y whose velocity before or after the step is not 0. `u_m_s`, `v_m_s`: the
/// new velocity.
void mark_moved_row(const CanvasState& state, int y, Columns cells, const float* u_m_s,
                    const float* v_m_s, std::uint8_t* moved);

/// Writes the new depth of row y. Returns whether any depth changed.
///   d = h+ - b
/// Scheme: exact. Source: R1, R6. Departures: where neither the cell nor one of its four neighbours
/// has moved, d is not rewritten. No paint has passed there, so a lake at rest keeps its bits; the
/// solve alone would level slopes that R14 holds. Films below kNoFilm_m become bare paper.
bool update_depth_row(const Planes& planes, const Field<float>& height_m, int y, Columns cells,
                      CanvasState& state);

}  // namespace pentimento::paper
