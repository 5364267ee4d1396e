#include "core/optics/spectral/spectrum.h"

#include <algorithm>
#include <cstddef>

#include "core/optics/spectral/illuminant.h"

namespace pentimento {
namespace {

using Vec = std::array<double, 3>;

Matrix3 product(const Matrix3& a, const Matrix3& b) {
  Matrix3 out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
  return out;
}

Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// By the adjugate: columns of the inverse are cross products of rows.
Matrix3 inverse(const Matrix3& m) {
  const Vec a = cross(m[1], m[2]), b = cross(m[2], m[0]), c = cross(m[0], m[1]);
  const double det = m[0][0] * a[0] + m[0][1] * a[1] + m[0][2] * a[2];
  Matrix3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = {a[i] / det, b[i] / det, c[i] / det};
  return out;
}

Xyz from_chromaticity(double x, double y) {
  return {x / y, 1, (1 - x - y) / y};
}

/// Bradford's cone responses (Lam 1985).
constexpr Matrix3 kBradford = {
    {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};

Matrix3 adaptation(const Xyz& from, const Xyz& to) {
  const Vec a = times(kBradford, from), b = times(kBradford, to);
  Matrix3 scaled = kBradford;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& value : scaled[i]) value *= b[i] / a[i];
  return product(inverse(kBradford), scaled);
}

/// Linear sRGB to XYZ, columns scaled so that (1,1,1) is the white.
Matrix3 rgb_to_xyz(const Xyz& white) {
  const Xyz primary[] = {from_chromaticity(0.64, 0.33), from_chromaticity(0.30, 0.60),
                         from_chromaticity(0.15, 0.06)};
  Matrix3 m{};
  for (std::size_t i = 0; i < 3; ++i) m[i] = {primary[0][i], primary[1][i], primary[2][i]};
  const Vec scale = times(inverse(m), white);
  for (auto& row : m)
    for (std::size_t j = 0; j < 3; ++j) row[j] *= scale[j];
  return m;
}

}  // namespace

std::array<double, 3> times(const Matrix3& m, const std::array<double, 3>& v) {
  Vec out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

std::array<double, 3> weighted(const SpectrumWeights& weights, const Spectrum& spectrum) {
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < spectrum.size(); ++i) out[c] += weights[c][i] * spectrum[i];
  return out;
}

SpectrumWeights xyz_weights(const Viewing& viewing) {
  const CieSpectrum power = illuminant_power(viewing.illuminant);
  const auto& cmf = color_matching(viewing.observer);
  SpectrumWeights out{};
  double luminance = 0;
  for (std::size_t i = 0; i < power.size(); ++i) {
    luminance += power[i] * cmf[i][1];
    // Every second sample lies midway between two of the spectrum's.
    const std::size_t last = kSpectrumSamples - 1;
    const std::size_t below = std::min(i / 2, last), above = std::min((i + 1) / 2, last);
    for (std::size_t c = 0; c < 3; ++c) {
      out[c][below] += power[i] * cmf[i][c] / 2;
      out[c][above] += power[i] * cmf[i][c] / 2;
    }
  }
  for (Spectrum& row : out)
    for (double& w : row) w /= luminance;
  return out;
}

Xyz white_xyz(const Viewing& viewing) {
  Spectrum white{};
  white.fill(1);
  return weighted(xyz_weights(viewing), white);
}

Matrix3 xyz_to_rgb(const Xyz& white) {
  const Xyz srgb_white = from_chromaticity(0.3127, 0.3290);
  return product(inverse(rgb_to_xyz(srgb_white)), adaptation(white, srgb_white));
}

SpectrumWeights rgb_weights(const Viewing& viewing) {
  const SpectrumWeights xyz = xyz_weights(viewing);
  const Matrix3 to_rgb = xyz_to_rgb(white_xyz(viewing));
  SpectrumWeights out{};
  for (std::size_t i = 0; i < kSpectrumSamples; ++i) {
    const auto rgb = times(to_rgb, {xyz[0][i], xyz[1][i], xyz[2][i]});
    for (std::size_t c = 0; c < 3; ++c) out[c][i] = rgb[c];
  }
  return out;
}

}  // namespace pentimento
