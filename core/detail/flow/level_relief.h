#pragma once
// Fresh paint levels below the guide's cells as soon as the brush has left it. Nothing else does so
// there: the guide's surface tension acts between its cells, and hairs leave tracks as fine as the
// detail canvas is.

#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/released_blocks.h"

namespace pentimento {

/// Levels the paint in blocks that the brush has released.
///   d' = e (S + l(h - S) - b),  h = b + d;  d' / d limited to [1/8, 8];  q' = q d' / d
/// S: a smooth surface that holds in each of the guide's cells what the guide's surface does; l:
/// level_bands(); e = sqrt(t (2 - t)) up to t = 1, t: the way to the nearest bare cell as a share
/// of the way on which paint rises to its depth at 56 degrees, half a cell of the guide at most, so
/// that paint ends round and not in a wall, and gives up little, which the lock heaps up behind; b:
/// base; q: every pigment. Bare cells stay bare. The yield stress is 100 Pa: paint from the tube,
/// whose brush marks stand; a furrow of a millimetre keeps 0.08 mm, one of a tenth a hundredth of
/// that. Scheme: pointwise, in one pass from the state before; levelling takes a hundredth of a
/// second at a millimetre (Orchard's rate), less than a step. Stable: bounded. Sums: restored by
/// the lock, so the guide does not notice. Source: relief_bands.h. Departs from it: the time is
/// left out. `tension_N_m` 0: nothing levels. Each block is listed once in `blocks`.
void level_relief(DetailCanvas& canvas, const CanvasState& guide,
                  const std::vector<ReleasedBlock>& blocks, float tension_N_m,
                  const Threads& threads);

}  // namespace pentimento
