#pragma once
// Quanta: amounts on the canvas are whole multiples of a quantum, which is a power of two. As long
// as amounts stay below 2^24 quanta, float sums and differences of them are exact in any order, so
// motion loses and makes no paint, however long it lasts. Above that, sums round as floats do.

namespace pentimento::conservative {

/// 2^-24 of the power of two at or above four times `scale` (> 0): the exact range is 4 `scale`.
inline float quantum_for(float scale) {
  float range = 1;
  while (range < 4 * scale) range *= 2;
  while (range >= 8 * scale) range *= 0.5f;
  return range * 0x1p-24f;
}

/// The number that rounds to quanta when it is added and subtracted again: 1.5 x 2^23 quanta. A
/// quantum of 0 turns rounding off.
inline float rounder_for(float quantum) {
  return quantum * 0x1.8p23f;
}

/// The nearest multiple of the quantum to `value`, ties to even.
inline float rounded(float value, float rounder) {
  return (value + rounder) - rounder;
}

}  // namespace pentimento::conservative
