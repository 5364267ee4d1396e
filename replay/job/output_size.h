#pragma once
// How large a picture becomes: in pixels, as a multiple of the log's grid, or on paper.

#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// At most one of width, height, scale and print may be set.
struct SizeRequest {
  std::optional<int> width;          // pixels; the height follows the canvas
  std::optional<int> height;         // pixels; the width follows
  std::optional<double> scale;       // times the log's grid
  std::optional<std::string> print;  // "60x45cm", "24x18in", "600x450mm", "A2"
  double dpi = 0;                    // dots per inch; 0 = not given (300 with `print`)
};

struct OutputSize {
  int width = 0;
  int height = 0;
  double dpi = 0;  // 0 = none
};

/// `grid`: the log's grid on its canvas. On a sheet the picture is as large as fits with the
/// canvas's shape; the sheet is upright or lies on its side as the canvas does. Errors: kUsage (two
/// ways, or text that is no size), kLimit (beyond 2^20 pixels a side).
Result<OutputSize> output_size(const SizeRequest& request, const CanvasGeometry& grid);

/// The detail that a picture wants: the smallest whole number with which no pixel is smaller than a
/// fine cell of `grid`.
int detail_wanted(const OutputSize& size, const CanvasGeometry& grid);

/// The detail that a picture gets: what it wants, but at most kMostDetail.
int detail_for(const OutputSize& size, const CanvasGeometry& grid);

}  // namespace pentimento
