#pragma once
// The cells at the sides of a stroke. The tip passes over a part of each only, and there the paint
// lies deeper than the cell's mean says. What levels against the height of the paint must know that
// height: else a cell at the side takes too much, up to a third, and the finer canvas of a poster,
// which has the side inside the cell, heaps it up as beads.

#include "core/brush/stamp_plan.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

/// Share of a cell that the tip passes over, as a table over v in tip coordinates, in [0.05,1].
///   p = 1 - c (1 - <r>),  at least 0.05
/// r: Tip::reach_table(); <>: mean over cell_width(); c: squared cosine between the stamp's way and
/// the tip's length (1 where it stands), for a tip that is dragged sideways has its sides
/// elsewhere. Source: ours. Departs from it: sides along u are not known.
BristleTable passed_shares(const StampPlan& plan, const CanvasGeometry& grid);

/// Height of the surface in the part of a cell that the tip passes over, m, if the rest is as high
/// as the lowest of the cells beside it:
///   H = l + (h - l) / p,  l = min(h, the four neighbours' h)
/// h: the cell's mean height b + d; p: passed_shares(). On a level film H = h. Cells beyond the
/// canvas do not count. Stable: h <= H <= l + 20 (h - l).
float passed_height_m(const CanvasState& canvas, int x, int y, float share);

}  // namespace pentimento
