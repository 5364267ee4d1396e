#pragma once
// Finds where paint moves in one part of a step.

#include "core/detail/store/changed_blocks.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

/// Adds to `blocks` the guide cells beside edges that move, in the cells of `runs`, and
/// kLevellingRadius cells around them (level_detail.h). Advection and levelling of the detail
/// canvas change no other cells.
void add_moving(const PaintEdges& edges, const std::vector<conservative::Run>& runs,
                ChangedBlocks& blocks);

}  // namespace pentimento
