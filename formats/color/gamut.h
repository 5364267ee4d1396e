#pragma once
// Gamut: turns colours that a picture's primaries cannot show into colours that they can show.

#include <array>

namespace pentimento {

/// Linear light, in a picture's own primaries.
using LinearRgb = std::array<float, 3>;

/// Moves a colour into [0,1]^3. What is too bright becomes darker, by three quarters of what it is
/// beyond (in its logarithm); then the colour moves along the line to the neutral of equal
/// luminance, no further than needed.
///   m = max(c);  b = c m^(-3/4) where m > 1, else c
///   Y = w . b;  n = (Y, Y, Y);  c' = n + t (b - n),  t = the largest in [0,1] with c' in [0,1]^3
/// So hue (dominant wavelength) stays, and luminance where nothing is too bright. A highlight pales
/// instead of shifting to the nearest secondary; paint that is lit a little too brightly keeps its
/// colour. Y >= 1 is white, Y <= 0 is black. A colour that lies inside is returned as it is, bit
/// for bit. The result is continuous in c. Source: the projecting clip of Stone, Cowan and Beatty,
/// Color Gamut Mapping and the Printing of Digital Color Images, ACM Trans. Graph. 7(4), 1988.
/// Departs from it: in linear light, and by the first of the two steps. Without it a yellow of
/// (1.27, 1.07, 0) is white beside a yellow of (1, 0.9, 0).
/// `weights`: luminance of each primary, sum 1. `c` may be infinite, not NaN.
LinearRgb into_gamut(const LinearRgb& c, const LinearRgb& weights);

}  // namespace pentimento
