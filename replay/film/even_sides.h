#pragma once
// Encoders of films take only frames of even sides. This is looked at before the work.

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "replay/job/output_size.h"
#include "replay/job/render_job.h"

namespace pentimento {

/// Whether the films among the outputs get even sides; `size` is that of the whole picture of
/// `canvas`. Errors: kUsage, with an option that makes the sides even.
Result<void> check_even_sides(const PictureChoice& picture, const OutputSize& size,
                              const CanvasGeometry& canvas);

}  // namespace pentimento
