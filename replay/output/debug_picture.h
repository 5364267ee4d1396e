#pragma once
// A debug view as a picture: colours of the cells, where each pixel shows the cell under its
// centre, and the legend below. It is written in strips, so that a large canvas is never held
// whole.

#include <vector>

#include "core/debug/debug_view.h"
#include "core/shading/picture.h"
#include "replay/job/control.h"
#include "replay/job/output_size.h"

namespace pentimento {

/// Which part of the canvas, and how large.
struct DebugFrame {
  OutputSize whole;       // the picture of the whole canvas
  int left = 0, top = 0;  // what is written of it, pixels
  int width = 0, height = 0;
};

/// Size of the file: the picture with its legend, and a margin if it is narrow.
OutputSize debug_picture_size(const OutputSize& written);

/// Writes strips of a picture of debug_picture_size() to each sink in turn. Errors: those of the
/// canvas, of the legend's text and of the sinks; kInterrupted.
Result<void> write_debug_picture(const DebugColors& colors, const CanvasSource& canvas,
                                 const ChannelBasis& basis, const DebugFrame& frame,
                                 const std::vector<PictureSink*>& sinks, const Control& control);

}  // namespace pentimento
