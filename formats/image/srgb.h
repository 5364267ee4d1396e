#pragma once
// The sRGB transfer curve (IEC 61966-2-1) between light and code values. Only + - * / sqrt, so
// that a picture loaded onto the canvas gives the same bits on every machine.

#include <bit>
#include <cstdint>
#include <vector>

namespace pentimento {

/// Linear light of the sRGB value `v` in [0,1]; relative error below 1e-14.
double srgb_to_linear(double v);
/// sRGB value of the linear light `v` in [0,1]; relative error below 1e-14.
double linear_to_srgb(double v);

/// Linear light to integer codes 0..max_code, rounded to the nearest code (on the sRGB scale).
class SrgbEncoder {
 public:
  /// `max_code`: 255 or 65535.
  explicit SrgbEncoder(int max_code);
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
    std::uint32_t code = start_[bucket] + ((width * (within >> 4)) >> (kBucketShift - 4));
    code += v >= threshold_[code + 1] ? 1u : 0u;
    code -= v < threshold_[code] ? 1u : 0u;
    while (v >= threshold_[code + 1]) ++code;
    while (v < threshold_[code]) --code;
    return static_cast<int>(code);
  }

 private:
  // A bucket is a range of floats with equal upper bits: 128 per octave, from 2^-21 to 1. Below
  // lies less than half a code of 16 bits.
  static constexpr int kBucketShift = 16;
  static constexpr std::uint32_t kFirstBits = (127u - 21u) << 23;
  static constexpr std::uint32_t kOneBits = 127u << 23;

  int max_code_;
  std::vector<float> threshold_;      // [c]: the smallest float that becomes code c
  std::vector<std::uint32_t> start_;  // per bucket of float bits: code of its smallest value
};

}  // namespace pentimento
