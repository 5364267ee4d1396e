#include "formats/color/gamut.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace pentimento {

namespace {
/// m^(-3/4) for m > 1: how much darker a colour becomes whose brightest part is m.
float darker_by(float m) {
  const float root = std::sqrt(m);
  return 1 / (root * std::sqrt(root));
}
}  // namespace

LinearRgb into_gamut(const LinearRgb& c, const LinearRgb& weights) {
  const bool inside = std::min({c[0], c[1], c[2]}) >= 0 && std::max({c[0], c[1], c[2]}) <= 1;
  if (inside) return c;
  constexpr float kLargest = 65504;  // keeps infinities out of the differences below
  LinearRgb finite;
  for (std::size_t i = 0; i < 3; ++i) finite[i] = std::clamp(c[i], -kLargest, kLargest);
  const float brightest = std::max({finite[0], finite[1], finite[2]});
  if (brightest > 1) {
    const float darker = darker_by(brightest);
    for (float& v : finite) v *= darker;
  }
  const float y = (weights[0] * finite[0] + weights[1] * finite[1]) + weights[2] * finite[2];
  if (y >= 1) return {1, 1, 1};
  if (y <= 0) return {0, 0, 0};
  float t = 1;
  for (const float v : finite) {
    if (v > 1) t = std::min(t, (1 - y) / (v - y));
    if (v < 0) t = std::min(t, y / (y - v));
  }
  LinearRgb out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = std::clamp(y + t * (finite[i] - y), 0.0f, 1.0f);  // rounding only
  return out;
}

}  // namespace pentimento
