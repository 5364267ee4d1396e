#pragma once
// Limiters: the slope of a cell's linear profile from the differences to its two neighbours.
// Inlined into the remap kernels.

#include <cmath>

namespace pentimento::conservative {

inline float smaller_magnitude(float a, float b) {
  return std::fabs(a) < std::fabs(b) ? a : b;
}
inline float larger_magnitude(float a, float b) {
  return std::fabs(a) > std::fabs(b) ? a : b;
}

/// Monotonised central difference (MC): the mean of the two differences, at most twice either of
/// them; 0 at extrema.
/// Source: van Leer, J. Comput. Phys. 23 (1977) 276-299.
inline float limited_mc(float below, float above) {
  const float steep = smaller_magnitude(2 * below, 2 * above);
  const float slope = smaller_magnitude(0.5f * (below + above), steep);
  return below * above > 0 ? slope : 0.0f;
}

/// Half of limited_mc(), in fewer operations: where it is not 0, both differences have the same
/// sign.
inline float half_limited_mc(float below, float above) {
  const float size_below = std::fabs(below);
  const float size_above = std::fabs(above);
  const float steep = size_below < size_above ? size_below : size_above;
  const float mean = 0.25f * (size_below + size_above);
  const float half = mean < steep ? mean : steep;
  return below * above > 0 ? std::copysign(half, below) : 0.0f;
}

/// Superbee: the steepest difference that makes no new extremum. Source: Roe, Ann. Rev. Fluid
/// Mech. 18 (1986) 337-365.
inline float limited_superbee(float below, float above) {
  const float slope =
      larger_magnitude(smaller_magnitude(2 * below, above), smaller_magnitude(below, 2 * above));
  return below * above > 0 ? slope : 0.0f;
}

inline float half_limited_superbee(float below, float above) {
  return 0.5f * limited_superbee(below, above);
}

}  // namespace pentimento::conservative
