#pragma once
// Encodes rows of scene-linear light (Rec. 709 primaries) as rows of a PNG: with the profile's
// primaries, gamut and curve, dithered or not. The result is a pure function of the light and of
// the pixel's position.

#include <cstdint>

#include "formats/color/code_encoder.h"
#include "formats/color/gamut.h"

namespace pentimento {

/// How light becomes integers.
struct ColorEncoding {
  ColorProfile profile = ColorProfile::kSrgb;
  bool dither = false;    // of 8-bit codes; 16-bit ones never are
  int left = 0, top = 0;  // of this picture in the whole one, pixels: where the noise begins
};

/// Red, green and blue of a row, linear light.
struct RgbRow {
  const float* r;
  const float* g;
  const float* b;
};

class RowEncoder {
 public:
  /// `bit_depth`: 8 or 16.
  RowEncoder(const ColorEncoding& encoding, int bit_depth);
  /// Encodes row `y` as `width` interleaved RGB pixels, high byte first. Returns false if a value
  /// is NaN.
  bool encode(const RgbRow& row, int width, int y, std::uint8_t* out) const;

 private:
  LinearRgb in_profile(const LinearRgb& light) const;
  bool encode_part(const RgbRow& light, int n, int x, int y, std::uint8_t* out) const;

  ColorEncoding encoding_;
  bool wide_;      // 16 bit
  bool dithered_;  // by way of 16-bit codes
  bool converts_;  // not Rec. 709's primaries
  std::array<LinearRgb, 3> matrix_;
  LinearRgb weights_;
  CodeEncoder encoder_;
};

}  // namespace pentimento
