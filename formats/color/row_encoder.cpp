#include "formats/color/row_encoder.h"

#include <algorithm>
#include <cmath>

#include "core/base/kernel.h"
#include "formats/color/dither.h"

namespace pentimento {

namespace {
LinearRgb to_float(const std::array<double, 3>& v) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
constexpr int kPartPixels = 64;  // that are encoded together

/// Whether all parts of `n` pixels lie in [0, 1].
PENTIMENTO_KERNEL
bool are_colors(const RgbRow& light, int n) {
  const RgbRow row = light;
  int outside = 0;  // not a bool, which keeps the loop from being a vector's
  for (int i = 0; i < n; ++i) {
    const float least = std::min(std::min(row.r[i], row.g[i]), row.b[i]);
    const float most = std::max(std::max(row.r[i], row.g[i]), row.b[i]);
    outside |= least >= 0 ? 0 : 1;
    outside |= most <= 1 ? 0 : 1;
  }
  return outside == 0;
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
  const int bytes = wide_ ? 6 : 3;
  bool numbers = true;
  for (int x = 0; x < width; x += kPartPixels, out += bytes * kPartPixels) {
    const RgbRow part = {row.r + x, row.g + x, row.b + x};
    if (!encode_part(part, std::min(kPartPixels, width - x), x, y, out)) numbers = false;
  }
  return numbers;
}

bool RowEncoder::encode_part(const RgbRow& light, int n, int x, int y, std::uint8_t* out) const {
  // Light that is a colour of the profile already is taken as it is.
  std::array<std::array<float, kPartPixels>, 3> color;
  RgbRow c = light;
  bool numbers = true;
  if (converts_ || !are_colors(light, n)) {
    c = {color[0].data(), color[1].data(), color[2].data()};
    for (int i = 0; i < n; ++i) {
      const LinearRgb here = {light.r[i], light.g[i], light.b[i]};
      if (std::isnan(here[0]) || std::isnan(here[1]) || std::isnan(here[2])) numbers = false;
      const LinearRgb inside = in_profile(here);
      for (std::size_t k = 0; k < 3; ++k) color[k][static_cast<std::size_t>(i)] = inside[k];
    }
  }
  // Codes, channel by channel; then their bytes side by side.
  std::array<int, kPartPixels> code;
  const int step = wide_ ? 6 : 3;
  for (int k = 0; k < 3; ++k) {
    encoder_.encode_row(k == 0 ? c.r : k == 1 ? c.g : c.b, n, code.data());
    if (dithered_)
      dither_row(x + encoding_.left, y + encoding_.top, k,
                 {code.data(), static_cast<std::size_t>(n)});
    std::uint8_t* to = out + (wide_ ? 2 * k : k);
    for (int i = 0; i < n; ++i, to += step) {
      const int whole = code[static_cast<std::size_t>(i)];
      if (wide_) to[1] = static_cast<std::uint8_t>(whole);
      to[0] = static_cast<std::uint8_t>(wide_ ? whole >> 8 : whole);
    }
  }
  return numbers;
}

}  // namespace pentimento
