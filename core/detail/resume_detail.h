#pragma once
// Brings back a detail canvas that was dumped.

#include "core/canvas/canvas_source.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/detail_checkpoint.h"

namespace pentimento {

/// Gives a clear canvas the tiles and planes that `checkpoint` lists, with the values of `fine`.
/// `fine` has the canvas's size, layers, channels and bands; `guide` is the guide's state at the
/// dump. The function reads tile by tile, plane after plane, and trims memory to the store's
/// budget. Errors: fine.status() if something could not be read, canvas.problem() if it could not
/// be kept.
void resume_detail(DetailCanvas& canvas, const CanvasSource& fine,
                   const DetailCheckpoint& checkpoint, const CanvasState& guide);

}  // namespace pentimento
