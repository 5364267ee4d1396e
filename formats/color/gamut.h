#pragma once
// Gamut: turns colours that a picture's primaries cannot show into colours that they can show.

#include <array>

namespace pentimento {

/// Linear light, in a picture's own primaries.
using LinearRgb = std::array<float, 3>;

/// Moves a colour into [0,1]^3, along the line to the neutral of equal luminance, no further than
/// needed.
///   Y = w . c;  n = (Y, Y, Y);  c' = n + t (c - n),  t = the largest in [0,1] with c' in [0,1]^3
/// So luminance and hue (dominant wavelength) stay and saturation gives way; a highlight beyond
/// white pales into white instead of shifting to the nearest secondary. Y >= 1 is white, Y <= 0 is
/// black. A colour that lies inside is returned as it is, bit for bit. The result is continuous in
/// c. Source: the projecting clip of Stone, Cowan and Beatty, Color Gamut Mapping and the Printing
/// of Digital Color Images, ACM Trans. Graph. 7(4), 1988. Departs from it: in linear light, so that
/// luminance stays exactly.
/// `weights`: luminance of each primary, sum 1. `c` may be infinite, not NaN.
LinearRgb into_gamut(const LinearRgb& c, const LinearRgb& weights);

}  // namespace pentimento
