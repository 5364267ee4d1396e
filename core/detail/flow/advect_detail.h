#pragma once
// The paint of the detail canvas goes where the guide's paint went.

#include <span>

#include "core/base/threads.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/tile_line.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

struct DetailAdvection {
  float residue = 0;              // of layer 0 stays on the paper (R19)
  std::span<const float> amount;  // per channel: its share in the total amount (A26)
};

/// Moves depth and every channel of every layer with the depth's edges along one axis, line by line
/// of fine cells, with the guide's edges interpolated between its rows (across) and its edges
/// (along). `moving`: the cells beside edges that move, and at least one around them; paint comes
/// no further than between edges that move. (Layer by layer, with the guide's edges of each, fine
/// paint is torn apart where guide cells with one layer and with two lie side by side; the lock
/// brings each layer's share back.)
void advect_detail(DetailCanvas& canvas, const PaintEdges& edges, Axis axis,
                   const ChangedBlocks& moving, const DetailAdvection& move,
                   const Threads& threads);

}  // namespace pentimento
