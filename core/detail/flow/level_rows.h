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

/// 0 at `low`, 1 at `low` + `rise`, smooth between; below, a skirt of at most 2 % of W^3, which
/// shows only where a block has nothing else.
inline __attribute__((always_inline)) float rising_profile(float wetness, float low, float rise) {
  constexpr float kSkirt = 0.02f;
  const float along = (wetness - low) / rise;
  const float least = along > 0 ? along : 0.0f;
  const float t = least < 1 ? least : 1.0f;
  const float edge = t * t * (3 - 2 * t), skirt = kSkirt * wetness * wetness * wetness;
  return edge > skirt ? edge : skirt;
}

/// m(W) of the film: it rises from W = 0.35 to 0.85.
inline __attribute__((always_inline)) float edge_profile(float wetness) {
  return rising_profile(wetness, 0.35f, 0.5f);
}

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
