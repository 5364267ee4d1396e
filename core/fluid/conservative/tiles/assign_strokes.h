#pragma once
// Paint that runs onto canvas where no brush has been stays its stroke's: when the brush comes
// after the paint that it pushed ahead, it finds its own, not another stroke's to lay a layer over.

#include <vector>

#include "core/base/runs.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"

namespace pentimento::conservative {

/// Cells of the runs that are wet and of no stroke become the latest stroke's of their four
/// neighbours', as these were before.
void assign_strokes(CanvasState& state, const std::vector<Run>& runs, const Threads& threads);

}  // namespace pentimento::conservative
