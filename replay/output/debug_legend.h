#pragma once
// The legend of a debug view, as rows under its picture: a title, a bar with numbers, and the
// colours that stand outside the scale.

#include <array>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/debug/debug_view.h"

namespace pentimento {

/// Narrower pictures get a margin at the right, so that the numbers fit.
inline constexpr int kLeastLegendWidth = 256;

/// Rows of the legend under a picture of `width` pixels.
int debug_legend_height(int width);

/// Draws the legend: red, green and blue in linear light, `width` x debug_legend_height(width).
/// Errors: kIo, the module that draws text cannot be loaded.
Result<std::array<Field<float>, 3>> draw_debug_legend(const DebugColors& colors, int width);

}  // namespace pentimento
