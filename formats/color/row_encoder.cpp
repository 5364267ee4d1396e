#include "formats/color/row_encoder.h"

#include <cmath>

#include "formats/color/dither.h"

namespace pentimento {

namespace {
LinearRgb to_float(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
}  // namespace

RowEncoder::RowEncoder(const ColorEncoding& encoding, int bit_depth)
    : encoding_(encoding),
      wide_(bit_depth == 16),
      dithered_(encoding.dither && !wide_),
      converts_(encoding.profile != ColorProfile::kSrgb),
      weights_(to_float(to_xyz(encoding.profile)[1])),
      encoder_(encoding.profile, wide_ || dithered_ ? 65535 : 255) {
  const ColorMatrix matrix = between(ColorProfile::kSrgb, encoding.profile);
  for (std::size_t i = 0; i < 3; ++i) matrix_[i] = to_float(matrix[i]);
}

LinearRgb RowEncoder::in_profile(const LinearRgb& light) const {
  if (!converts_) return into_gamut(light, weights_);
  constexpr float kLargest = 65504;  // an infinite highlight is white, not infinity - infinity
  LinearRgb c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = std::fmin(std::fmax(light[i], -kLargest), kLargest);
  LinearRgb out;
  for (std::size_t i = 0; i < 3; ++i)
    out[i] = (matrix_[i][0] * c[0] + matrix_[i][1] * c[1]) + matrix_[i][2] * c[2];
  return into_gamut(out, weights_);
}

bool RowEncoder::encode(const RgbRow& row, int width, int y, std::uint8_t* out) const {
  bool numbers = true;
  for (int x = 0; x < width; ++x) {
    const LinearRgb light = {row.r[x], row.g[x], row.b[x]};
    if (std::isnan(light[0]) || std::isnan(light[1]) || std::isnan(light[2])) numbers = false;
    const LinearRgb c = in_profile(light);
    for (int i = 0; i < 3; ++i) {
      int code = encoder_.encode(c[static_cast<std::size_t>(i)]);
      if (dithered_) code = dithered_code(code, x + encoding_.left, y + encoding_.top, i);
      if (wide_) *out++ = static_cast<std::uint8_t>(code >> 8);
      *out++ = static_cast<std::uint8_t>(code);
    }
  }
  return numbers;
}

}  // namespace pentimento
