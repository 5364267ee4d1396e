#pragma once
// The exponential of numbers that are not positive, as a few lines without branches, so that a loop
// over a row becomes vector instructions. For pictures; what reaches the state uses approx.h.

#include <algorithm>
#include <bit>
#include <cstdint>

namespace pentimento {

/// exp(x) for x <= 0, within 3e-7 relative; below -87 the value there, 1.6e-38.
/// Source: Cody and Waite 1980: 2^k exp(r) with |r| <= ln 2 / 2, a Taylor polynomial of order 6.
inline float row_exp(float x) {
  x = std::max(x, -87.0f);
  // k: to the nearest; the int cast cuts, and the number is not positive.
  const auto k = static_cast<std::int32_t>(x * 1.44269504f - 0.5f);
  const auto whole = static_cast<float>(k);
  const float r = (x - whole * 0.693145752f) - whole * 1.42860677e-6f;
  const float p =
      1 +
      r * (1 + r * (0.5f + r * (0.166666672f +
                                r * (0.0416666679f + r * (8.33333377e-3f + r * 1.38888892e-3f)))));
  return p * std::bit_cast<float>((k + 127) << 23);
}

}  // namespace pentimento
