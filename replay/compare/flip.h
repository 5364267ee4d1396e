#pragma once
// FLIP, the difference that a viewer sees when switching between two pictures.
// Source: Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild, FLIP: A Difference
// Evaluator for Alternating Images, Proc. ACM CGIT 3(2), 2020 (the LDR form).

#include <array>

#include "core/base/field.h"
#include "core/base/threads.h"

namespace pentimento {

/// Three planes of one size: linear red, green, blue. Values are clamped to [0,1].
using RgbPlanes = std::array<FieldView<const float>, 3>;

/// A picture 0.7 m away on a screen 0.7 m and 3840 pixels wide, as the paper has it.
inline constexpr double kFlipPixelsPerDegree = 67.0;

/// FLIP per pixel, 0 (equal) to 1. Both pictures have the same size.
Field<float> flip_map(const RgbPlanes& reference, const RgbPlanes& test, double pixels_per_degree,
                      const Threads& threads);

}  // namespace pentimento
