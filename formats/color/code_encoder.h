#pragma once
// Turns linear light into the integer codes of a picture, through a table. It is as fast as a
// lookup and as exact as the curve itself.

#include <bit>
#include <cstdint>
#include <vector>

#include "formats/color/color_profile.h"

namespace pentimento {

/// Encodes linear light as integer codes 0..max_code, rounded to the nearest code on the encoded
/// scale.
class CodeEncoder {
 public:
  /// `max_code`: 255 or 65535.
  CodeEncoder(ColorProfile profile, int max_code);
  /// Values outside [0,1] are clamped; `v` must not be NaN.
  int encode(float v) const {
    if (!(v > 0)) return 0;
    if (v >= 1) return max_code_;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(v);
    if (bits < kFirstBits) return 0;
    // Close to where the value lies within its bucket; the thresholds decide. One code up or down
    // without a branch is nearly always enough, and the loops see to the rest.
    const std::uint32_t bucket = (bits - kFirstBits) >> kBucketShift;
    const std::uint32_t within = bits & ((1u << kBucketShift) - 1);
    const std::uint32_t width = start_[bucket + 1] - start_[bucket];
    std::uint32_t code =
        (start_[bucket] + ((width * (within >> 4)) >> (kBucketShift - 4))) >> kPartShift;
    code += v >= threshold_[code + 1] ? 1u : 0u;
    code -= v < threshold_[code] ? 1u : 0u;
    while (v >= threshold_[code + 1]) ++code;
    while (v < threshold_[code]) --code;
    return static_cast<int>(code);
  }
  /// The same for `n` values of a row, by vectors.
  void encode_row(const float* v, int n, int* code) const;

 private:
  // A bucket is a range of floats with equal upper bits: 128 per octave, from 2^-38 to 1. Below
  // lies less than half a code of 16 bits on the steepest of the curves, 563/256.
  static constexpr int kBucketShift = 16;
  static constexpr std::uint32_t kFirstBits = (127u - 38u) << 23;
  static constexpr std::uint32_t kOneBits = 127u << 23;
  static constexpr int kPartShift = 8;  // a code has 256 parts

  int max_code_;
  std::vector<float> threshold_;  // [c]: the smallest float that becomes code c
  // Per bucket of float bits: where its smallest value lies between the edges of codes, in parts of
  // a code.
  std::vector<std::uint32_t> start_;
};

}  // namespace pentimento
