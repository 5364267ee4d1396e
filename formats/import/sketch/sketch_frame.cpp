#include "formats/import/sketch/sketch_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/log/tables/ranges.h"

namespace pentimento::sketch {

namespace {
constexpr double kMarginFrac = 0.04;         // of the longer side: strokes do not end at the border
constexpr double kLeastSideFrac = 1.0 / 16;  // of the longer side: a line becomes a strip

Page bounds_of(const Sketch& sketch) {
  double left = INFINITY, top = INFINITY, right = -INFINITY, bottom = -INFINITY;
  for (const Item& item : sketch.items) {
    const auto* stroke = std::get_if<Stroke>(&item);
    if (stroke == nullptr) continue;
    const double half = stroke->width / 2;
    for (const Sample& s : stroke->samples) {
      left = std::min(left, s.x - half);
      right = std::max(right, s.x + half);
      top = std::min(top, s.y - half);
      bottom = std::max(bottom, s.y + half);
    }
  }
  if (left > right) return {0, 0, 4, 3};  // no stroke at all
  const double longer = std::max({right - left, bottom - top, 1e-9});
  const double margin = kMarginFrac * longer;
  return {left - margin, top - margin, right - left + 2 * margin, bottom - top + 2 * margin};
}

/// At least a sixteenth as wide as long, about the same centre.
Page widened(Page page) {
  const double least = kLeastSideFrac * std::max(page.width, page.height);
  const double add_x = std::max(least - page.width, 0.0);
  const double add_y = std::max(least - page.height, 0.0);
  return {page.x - add_x / 2, page.y - add_y / 2, page.width + add_x, page.height + add_y};
}
}  // namespace

Result<SketchFrame> frame_of(const Sketch& sketch, int cells) {
  const Page page = widened(sketch.page ? *sketch.page : bounds_of(sketch));
  const double longer = std::max(page.width, page.height);
  SketchFrame out;
  out.x0 = page.x;
  out.y0 = page.y;
  out.metre_per_unit = sketch.metre_per_unit ? *sketch.metre_per_unit : 1 / longer;
  // Without a unit by division, so that the longer side is 1 m exactly.
  const auto metres = [&](double side) {
    return sketch.metre_per_unit ? side * *sketch.metre_per_unit : side / longer;
  };
  out.canvas_width_m = metres(page.width);
  out.canvas_height_m = metres(page.height);
  const log::Range& range = log::kCanvasRange;
  for (const double side : {out.canvas_width_m, out.canvas_height_m})
    if (!(side >= range.min && side <= range.max))
      return Error{ErrorCode::kBadInput,
                   fmt::format("the drawing is {:.3g} x {:.3g} m, a canvas has {} to {} m a side",
                               out.canvas_width_m, out.canvas_height_m, range.min, range.max)};
  const auto along = [&](double side) {
    return std::max(1, static_cast<int>(std::lround(side / longer * cells)));
  };
  out.grid_width = along(page.width);
  out.grid_height = along(page.height);
  return out;
}

}  // namespace pentimento::sketch
