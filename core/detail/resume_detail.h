#pragma once
// A detail canvas that was dumped, to go on with.

#include "core/canvas/canvas_source.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/detail_checkpoint.h"

namespace pentimento {

/// Gives a clear canvas the tiles and planes that `checkpoint` tell of, with the values of `fine`,
/// which has the canvas's size, layers, channels and bands; `guide` goes with both. Reads tile by
/// tile, plane after plane, and lets go of what the store cannot hold. What could not be read or
/// kept: fine.status() and canvas.problem() tell.
void resume_detail(DetailCanvas& canvas, const CanvasSource& fine,
                   const DetailCheckpoint& checkpoint, const CanvasState& guide);

}  // namespace pentimento
