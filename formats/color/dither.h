#pragma once
// Dithering of 8-bit codes: noise of about a code hides the steps of a smooth gradient. The noise
// follows from the pixel's position in the whole picture alone, so threads, tiles, strips and crops
// do not change it.

#include <cstdint>
#include <span>

#include "core/base/random.h"

namespace pentimento {

/// Steps of a 16-bit code in one of an 8-bit code: code 257 c of 65535 is exactly code c of 255.
inline constexpr int kStepsPerCode = 257;

/// Uniform in 0..256 for each (x, y, channel).
inline int dither_uniform(int x, int y, int channel) {
  const std::uint64_t place = static_cast<std::uint64_t>(static_cast<std::uint32_t>(y)) << 32 |
                              static_cast<std::uint32_t>(x);
  const std::uint64_t bits = splitmix64(place, static_cast<std::uint64_t>(channel) + 1) >> 40;
  return static_cast<int>((bits * kStepsPerCode) >> 24);
}

/// Turns a 16-bit code into a dithered 8-bit code: round(v + d). The noise d is triangular in (-1,
/// 1) codes with mean 0: it is the difference of the uniform numbers of this pixel and of its left
/// neighbour. So the mean of many pixels is v for every v, the noise does not depend on v, and it
/// is weak at low frequencies along a row, where eyes see best. Within half a code of black and
/// white d is uniform in half a code, so nothing is clipped, and pure black and white stay clean.
/// Source: Lipshitz, Wannamaker and Vanderkooy, Quantization and Dither: A Theoretical Survey, J.
/// Audio Eng. Soc. 40(5), 1992 (triangular dither, and its high-pass kind).
inline int dithered_code(int code16, int x, int y, int channel) {
  constexpr int kHalf = kStepsPerCode / 2;
  const int here = dither_uniform(x, y, channel);
  const bool at_an_end = code16 < kHalf || code16 > 65535 - kHalf;
  const int noise = at_an_end ? here - kHalf : here - dither_uniform(x - 1, y, channel);
  return (code16 + noise + kHalf) / kStepsPerCode;
}

/// dithered_code() of the channel's codes in the pixels (x ..., y) of a row, in place, by vectors.
void dither_row(int x, int y, int channel, std::span<int> code);

}  // namespace pentimento
