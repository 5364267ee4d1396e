#pragma once
// Where the paint of a step's part moves.

#include "core/detail/store/changed_blocks.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

/// Adds the guide cells beside edges that move, in the cells of `runs`, and kLevellingRadius cells
/// around them (level_detail.h): all that the detail's motion and its levelling may change.
void add_moving(const PaintEdges& edges, const std::vector<conservative::Run>& runs,
                ChangedBlocks& blocks);

}  // namespace pentimento
