#pragma once
// The tips as drawings. A tip lives in the unit square: u along the stroke, v across it, both in
// [-1/2, 1/2]; value 1 = most paint. Bristles are uneven across the stroke, which is what leaves
// furrows, and of uneven length, which leaves ragged ends and lets a light hand touch with the
// longest only. Only + - * / sqrt.

#include <cstdint>

#include "core/base/field.h"
#include "core/brush/brush_settings.h"

namespace pentimento {

/// How far a tip reaches from the centre, in halves of the diameter, along u and v.
struct TipExtent {
  float u = 1;
  float v = 1;
};

/// Whether pressing the brush down changes the drawing.
bool has_bristles(const BrushDefinition& brush);

/// The brush pressed down by `press` in [0,1], as a `size` x `size` map of area means (rows: v,
/// columns: u). `seed` chooses the bristles. A texture is resampled, its mean kept; with bristles
/// they are drawn in its light.
Field<float> draw_tip(const BrushDefinition& brush, int size, std::uint64_t seed, float press = 1);

/// How strongly the bristles at v (in halves of the diameter) take hold of the paint they meet, 1
/// on average, in [0, 2]: clumps of bristle lift and stir more than what lies between them, so that
/// wet colours streak instead of blending evenly. A blade and a texture are even: 1.
float bristle_grip(const BrushDefinition& brush, float v, std::uint64_t seed);

/// How much of its paint the bristle at v (in halves of the diameter) still gives when the brush
/// holds `density_frac` of its fluid: 1 when full; one by one they run dry.
float bristle_supply(float v, float density_frac, std::uint64_t seed);

}  // namespace pentimento
