#pragma once
// The exponential of numbers that are not positive. It has no branches, so a loop over a row
// becomes vector instructions. It is for pictures; what reaches the state uses approx.h.

#include <algorithm>
#include <bit>
#include <cstdint>

namespace pentimento {

/// exp(x) for x <= 0, within 3e-7 relative. For x < -87 it gives exp(-87) = 1.6e-38.
/// Source: Cody and Waite 1980: 2^k exp(r) with |r| <= ln 2 / 2, a Taylor polynomial of order 6.
inline float row_exp(float x) {
  x = std::max(x, -87.0f);
  // k is rounded to the nearest: the cast cuts towards 0, and the number is not positive.
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
