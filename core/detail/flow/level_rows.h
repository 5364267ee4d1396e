#pragma once
// Rows of fine cells that level (level_detail.h): pure functions.

namespace pentimento {

/// Smooth fields of the guide over a row of fine cells, n values each.
struct LevelRow {
  const float* rate;     // L, [0, 1); 0: the cell stays as it is, bit for bit
  const float* wet;      // W, [0, 1]
  const float* depth_m;  // smooth d_g
  const float* base_m;   // smooth b_g
};

/// m(W) of the film: 0 at 0.35, 1 at 0.85, smooth between; below, a skirt of at most 1 % of the
/// film, which shows only where a block has nothing else.
float edge_profile(float wetness);

/// d += L (m(W) max(0, S + b_s - b) - d),  S = d_s / W, over n cells.
/// Scheme: relaxation. Stable: 0 <= L < 1, so d stays between itself and the target, >= 0.
/// Source: level_detail.h. Departs from it: nothing.
void relax_depth_row(const LevelRow& guide, const float* base_m, int n, float* depth_m);

/// Smooth fields of one pigment of the guide.
struct LevelPigmentRow {
  const float* amount;
  const float* depth_m;   // the guide's depth, smoothed in the same way
  const float* coverage;  // how full of this pigment, [0, 1]
};

/// The change of a pigment a with the depth, which was d and is d':
///   a *= d' / d where d' < d;  a += (d' - d) a_s / d_s elsewhere
/// then near the pigment's own edge, over its wetness E = a_s's fullness:
///   a += L min(1, 4 (1 - E)) (m(E + 0.12) a_s / E - a)
/// Scheme: pointwise. Stable: a stays >= 0.
/// Source: level_detail.h. Departs from it: nothing.
void relax_pigment_row(const LevelRow& guide, const LevelPigmentRow& pigment, const float* before_m,
                       const float* after_m, int n, float* amount);

}  // namespace pentimento
