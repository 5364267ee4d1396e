#pragma once
// The tips as drawings. A tip lives in the unit square: u along the stroke, v across it, both in
// [-1/2, 1/2]; value 1 = most paint. Bristles are uneven across the stroke and leave furrows. Their
// lengths are uneven too, so strokes end ragged, and a light hand touches with the longest bristles
// only. The code uses only + - * / and sqrt.

#include <cstdint>

#include "core/base/field.h"
#include "core/brush/brush_settings.h"

namespace pentimento {

/// How far a tip reaches from the centre, in halves of the diameter, along u and v.
struct TipExtent {
  float u = 1;
  float v = 1;
};

/// Whether the tip has bristles, so that the press changes its drawing.
bool has_bristles(const BrushDefinition& brush);

/// Draws the tip pressed down by `press` in [0,1], as a `size` x `size` map of area means (rows: v,
/// columns: u), values in [0,1]. `seed` chooses the bristles. A texture is resampled with its mean
/// kept; if the brush has bristles too, the texture shades them.
Field<float> draw_tip(const BrushDefinition& brush, int size, std::uint64_t seed, float press = 1);

/// The grip at v (in halves of the diameter): how strongly the bristles there take hold of the
/// paint that they meet, in [0, 2] with mean 1. Clumps of bristles pick up and stir more than the
/// gaps between them, so wet colours streak instead of blending evenly. A blade and a texture have
/// an even grip of 1.
float bristle_grip(const BrushDefinition& brush, float v, std::uint64_t seed);

/// Share of its paint, in [0,1], that the bristle at v (in halves of the diameter) still gives when
/// the brush holds `density_frac` of its fluid. It is 1 when the brush is full; then the bristles
/// run dry one by one.
float bristle_supply(float v, float density_frac, std::uint64_t seed);

}  // namespace pentimento
