#pragma once
// Where a sketch lies on the log's canvas.

#include "core/base/result.h"
#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// From the source's unit to the canvas: x_m = (x - x0) * metre_per_unit. The grid's cells are
/// square.
struct SketchFrame {
  double x0 = 0, y0 = 0;
  double metre_per_unit = 1;
  double canvas_width_m = 1, canvas_height_m = 0.75;
  int grid_width = 1024, grid_height = 768;
};

/// Fits the page, or else the bounds of all strokes with a margin, to a canvas whose longer side is
/// 1 m and `cells` cells long; the shorter side is at least a sixteenth of it. A sketch that has a
/// unit keeps its size. Errors: kBadInput, if the size is none that a log can have.
Result<SketchFrame> frame_of(const Sketch& sketch, int cells);

}  // namespace pentimento::sketch
