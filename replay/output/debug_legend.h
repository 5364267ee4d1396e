#pragma once
// What the colours of a debug view mean, as rows to stand under its picture: a title, a bar with
// numbers, and what has a colour of its own.

#include <array>

#include "core/base/field.h"
#include "core/base/result.h"
#include "core/debug/debug_view.h"

namespace pentimento {

/// Narrower pictures get a margin at the right, so that the numbers fit.
inline constexpr int kLeastLegendWidth = 256;

/// Rows of the legend under a picture of `width` pixels.
int debug_legend_height(int width);

/// Red, green and blue in linear light, `width` x debug_legend_height(width). Errors: kIo, the
/// module that draws text cannot be loaded.
Result<std::array<Field<float>, 3>> draw_debug_legend(const DebugColors& colors, int width);

}  // namespace pentimento
