#pragma once
// The edge of fresh paint on the detail canvas. Oil meets bare canvas at an angle. A tip that
// trembles and changes its width from stamp to stamp leaves an edge that thins out to nothing, so
// the edge is steepened.

#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/released_blocks.h"

namespace pentimento {

/// Draws the fringe of paint into the paint beside it, in blocks at the sides of strokes: they have
/// bare canvas within two cells, and the guide's paint falls steeply there, across the brush's way.
///   w = 1 + s (max(S(0.06, 0.22, h / h_max), 0.2, h_out / h) - 1);  q *= w q_block / (w q)_block
///   s = S(0.12, 0.25, |grad h| dx / h_max) S(0.4, 0.8, 1 - (way . grad h / |grad h|)^2)
/// S: smooth step; h: depth of the fine cell; h_max: the guide's largest depth within two cells;
/// h_out: the least beside the cell; _block: mean over the block; q: depth and every pigment plane.
/// Scheme: pointwise, then one ratio per block. Stable: amounts stay >= 0, each block keeps what it
/// has of everything to rounding, so the guide does not notice.
/// Source: ours; the edge profile of thin films in level_detail.h. Departs from it: nothing. Each
/// block is listed once in `blocks`.
void steepen_edges(DetailCanvas& canvas, const CanvasState& guide,
                   const std::vector<ReleasedBlock>& blocks, const Threads& threads);

}  // namespace pentimento
