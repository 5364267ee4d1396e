#pragma once
// The state of the guide as a part of a slot. Of each row only the values between the first and the
// last that are not 0 are kept, for most planes of most canvases are empty. The relief of the paper
// is left out: it is made from the log again.

#include <optional>

#include "core/canvas/canvas_state.h"
#include "formats/checkpoint/archive.h"

namespace pentimento::checkpoint {

void put_canvas(const CanvasState& state, ArchiveWriter& to);

/// What the canvas must be: grid, layers, channels, bands.
struct GuideShape {
  CanvasGeometry geometry;
  int layers = 0, channels = 0, bands = 0;
};

/// The paper is not in the part, and comes out as `base_m`. If the bytes are of another canvas, or
/// hold what no canvas holds, the reader has the problem.
CanvasState take_canvas(const GuideShape& shape, ArchiveReader& from);

}  // namespace pentimento::checkpoint
