#pragma once
// The relief of fine cells, band by band of wavelengths, and how much of each band fresh paint can
// hold against its surface tension. Pure functions on planes.

#include "core/base/field.h"

namespace pentimento {

/// What holds the relief of paint up and what pulls it flat.
struct ReliefStrength {
  float yield_per_tension_per_m = 0;  // yield stress / surface tension: the steepest curvature
  float cell_m = 0;                   // side of a fine cell
};

/// Amplitude of a ripple that the yield stress t holds against the surface tension s, on a film of
/// depth d:
///   a = t / (s q^2) max(1, 1 / (q d)),  q = 2 pi / wavelength
/// On a deep film the curvature's pressure s q^2 a must yield the paint under the ripple; on one
/// that is thin against the wavelength the pressure's gradient over its depth, s q^3 a d, must.
/// Source: Orchard 1962 for the pressure; a film that creeps where the stress is over t. Departs
/// from it: factors of order one are left out. All arguments > 0.
float standing_amplitude_m(const ReliefStrength& strength, float wavelength_m, float film_m);

/// out = the mean of `in` under a triangle of 2 width - 1 cells along both axes; beyond the edges
/// the outermost cells repeat. Two running means; sums in double. Planes of one size.
void triangle_mean(const Field<float>& in, int width, Field<float>& out);

/// Levels `relief_m` (height over a smooth surface) of films of depth `film_m`:
///   r' = B_(k/2) r + sum_j l(B_(w/2) r - B_w r),  w = k/2, k/4, ... while w > 1;  B_1 r = r
///   l(a) = a / sqrt(1 + (a / m)^2),  m = standing_amplitude_m(1.5 w cells)
/// B: triangle_mean(). Waves longer than a cell of the guide (k = `factor` fine cells) stay.
/// Scheme: one pass; what stands is the amplitude at the end, however long it takes. Stable: no
/// band grows. The bands of k and of 2 k have the same wavelengths in metres, so the slopes do not
/// grow with k.
void level_bands(const ReliefStrength& strength, int factor, const Field<float>& film_m,
                 Field<float>& relief_m);

}  // namespace pentimento
