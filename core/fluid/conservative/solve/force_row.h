#pragma once
// Gravity along the canvas and bed friction, on a row of faces.

namespace pentimento::conservative {

struct LateralGravity {
  float speed_m_s = 0;             // dt g_x, as an accelerometer reads it
  float dry_film_m = 0;            // thinner films feel no gravity (R15)
  bool scaled_by_mobility = true;  // reading (a) of A7; false: stiff paint slides too
};

/// u* = friction (u - dt mobility g), in place.
/// Scheme: friction implicit, gravity explicit, 1st order; a uniform film under tilt reaches
///   u = g d^2 / (3 nu) exactly.
/// Stable: any dt.
/// Source: R11 with A7, R15 (Stuyck et al. 2016, equation 4).
/// Departs from it: bed friction (face_row.h), with the drag of the paint beside it (drag_row.h).
void force_row(const LateralGravity& g, const float* depth_m, const float* mobility_frac,
               const float* friction_frac, int n, float* velocity_m_s);

}  // namespace pentimento::conservative
