#pragma once
// Where the paint of a step's part moves.

#include "core/detail/changed_blocks.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

/// Adds the guide cells beside edges that move, in the cells of `runs`, and the two cells around
/// them, into which the detail's paint may come and from which its levelling sees them.
void add_moving(const PaintEdges& edges, const std::vector<conservative::Run>& runs,
                ChangedBlocks& blocks);

}  // namespace pentimento
