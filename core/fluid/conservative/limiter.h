#pragma once
// Limited differences for linear profiles in cells; inlined into the remap kernels.

namespace pentimento::conservative {

inline float smaller_magnitude(float a, float b) {
  const float abs_a = a < 0 ? -a : a;
  const float abs_b = b < 0 ? -b : b;
  return abs_a < abs_b ? a : b;
}
inline float larger_magnitude(float a, float b) {
  const float abs_a = a < 0 ? -a : a;
  const float abs_b = b < 0 ? -b : b;
  return abs_a > abs_b ? a : b;
}

/// Monotonised central difference: the mean difference, at most twice either; 0 at extrema.
/// Source: van Leer, J. Comput. Phys. 23 (1977) 276-299.
inline float limited_mc(float below, float above) {
  const float steep = smaller_magnitude(2 * below, 2 * above);
  const float slope = smaller_magnitude(0.5f * (below + above), steep);
  return below * above > 0 ? slope : 0.0f;
}

/// Superbee: the steepest difference that makes no new extremum. Source: Roe, Ann. Rev. Fluid
/// Mech. 18 (1986) 337-365.
inline float limited_superbee(float below, float above) {
  const float slope =
      larger_magnitude(smaller_magnitude(2 * below, above), smaller_magnitude(below, 2 * above));
  return below * above > 0 ? slope : 0.0f;
}

}  // namespace pentimento::conservative
