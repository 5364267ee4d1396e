#pragma once
// The built-in tips as drawings. A tip lives in the unit square: u along the stroke, v across it,
// both in [-1/2, 1/2]; value 1 = most paint. Hairs are uneven across the stroke, which is what
// leaves furrows, and of uneven length, which leaves ragged ends. Only + - * / sqrt.

#include <cstdint>

#include "core/brush/brush_settings.h"
#include "core/field.h"

namespace pentimento {

/// How far a shape reaches from the centre, in halves of the diameter, along u and v.
struct TipExtent {
  float u = 1;
  float v = 1;
};
TipExtent tip_extent(TipShape shape);

/// The shape as a `size` x `size` map of area means (rows: v, columns: u). `seed` chooses the
/// hairs. kTexture: the brush's own texture, resampled; its mean is kept.
Field<float> draw_tip(const BrushDefinition& brush, int size, std::uint64_t seed);

/// How strongly the hairs at v (in halves of the diameter) take hold of the paint they meet, 1 on
/// average, in [0, 2]: clumps of hair lift and stir more than what lies between them, so that wet
/// colours streak instead of blending evenly. A blade and a texture are even: 1.
float hair_grip(TipShape shape, float v, std::uint64_t seed);

}  // namespace pentimento
