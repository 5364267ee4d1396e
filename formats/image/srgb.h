#pragma once
// The sRGB transfer curve (IEC 61966-2-1) between light and code values. Only + - * / sqrt, so
// that a picture loaded onto the canvas gives the same bits on every machine.

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
  int encode(float v) const;

 private:
  int max_code_;
  std::vector<float> threshold_;      // [c]: the smallest float that becomes code c
  std::vector<std::uint32_t> start_;  // per bucket of float bits: code of its smallest value
};

}  // namespace pentimento
