#pragma once
// Paint that runs onto canvas where no brush has been keeps the id of its stroke. So a brush that
// comes after the paint that it pushed ahead finds paint of its own stroke, and does not open a
// layer over it.

#include <vector>

#include "core/base/runs.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"

namespace pentimento::conservative {

/// Gives cells of the runs that are wet and have no stroke id the latest (largest) id of their four
/// neighbours, as these were before the call.
void assign_strokes(CanvasState& state, const std::vector<Run>& runs, const Threads& threads);

}  // namespace pentimento::conservative
