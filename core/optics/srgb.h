#pragma once
// The sRGB transfer curve (IEC 61966-2-1) between encoded values and linear light, both 0..1.
// Made of core's own functions, so that a colour of a log is the same bits on every machine.

#include <array>

#include "core/base/approx.h"

namespace pentimento {

/// Linear light of an encoded value.
constexpr double srgb_to_linear(double encoded) {
  if (encoded <= 0.04045) return encoded / 12.92;
  return approx::pow((encoded + 0.055) / 1.055, 2.4);
}

/// Encoded value of linear light.
constexpr double linear_to_srgb(double linear) {
  if (linear <= 0.0031308) return linear * 12.92;
  return 1.055 * approx::pow(linear, 1 / 2.4) - 0.055;
}

/// Linear light of each 8-bit encoded value.
inline constexpr std::array<double, 256> kSrgb8ToLinear = [] {
  std::array<double, 256> table{};
  for (int i = 0; i < 256; ++i) table[static_cast<std::size_t>(i)] = srgb_to_linear(i / 255.0);
  return table;
}();

}  // namespace pentimento
