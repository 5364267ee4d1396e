#pragma once
// Advection on the detail canvas: its paint goes where the guide's paint went.

#include <span>

#include "core/base/threads.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/tile_line.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

struct DetailAdvection {
  float residue = 0;              // amount of layer 0 that stays on the paper (R19)
  std::span<const float> amount;  // per channel: its share in the total amount (A26)
};

/// Moves depth and every channel of every layer along one axis, line by line of fine cells. All
/// move with the edges of the guide's depth, which are interpolated between the guide's rows across
/// the motion and between its edges along it. `moving`: the cells beside edges that move, and at
/// least one cell around them; paint stays between edges that move. Why the layers do not move with
/// their own edges: fine paint would be torn apart where guide cells with one layer and with two
/// lie side by side. The lock brings each layer's share back.
void advect_detail(DetailCanvas& canvas, const PaintEdges& edges, Axis axis,
                   const ChangedBlocks& moving, const DetailAdvection& move,
                   const Threads& threads);

}  // namespace pentimento
