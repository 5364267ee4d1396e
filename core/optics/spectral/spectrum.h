#pragma once
// Spectra of paint on the wavelengths of the measured library, and the matrices that turn them into
// colours. Plain loops in fixed order: upsampled colours reach the state.

#include <array>

#include "core/optics/spectral/observer.h"

namespace pentimento {

/// 380, 390 .. 750 nm.
inline constexpr int kSpectrumSamples = 38;
constexpr double spectrum_wavelength_nm(int sample) {
  return 380 + 10 * sample;
}
using Spectrum = std::array<double, kSpectrumSamples>;

using Matrix3 = std::array<std::array<double, 3>, 3>;
/// Weight of each sample in three numbers.
using SpectrumWeights = std::array<Spectrum, 3>;

/// XYZ of a reflectance, Y = 1 for a perfect white: illuminant times observer at 5 nm, the
/// reflectance linear between its samples and constant beyond them.
SpectrumWeights xyz_weights(const Viewing& viewing);

/// XYZ of a perfect white.
Xyz white_xyz(const Viewing& viewing);

/// Linear sRGB of a reflectance, as its observer would see it adapted to the light: XYZ, adapted to
/// the white of sRGB (Bradford; Lindbloom, Chromatic Adaptation), in sRGB's primaries (IEC
/// 61966-2-1). A perfect white is (1,1,1). Colours outside sRGB have negative components.
SpectrumWeights rgb_weights(const Viewing& viewing);

/// From XYZ beside `white` to linear sRGB, adapted likewise.
Matrix3 xyz_to_rgb(const Xyz& white);

std::array<double, 3> weighted(const SpectrumWeights& weights, const Spectrum& spectrum);
std::array<double, 3> times(const Matrix3& matrix, const std::array<double, 3>& v);

}  // namespace pentimento
