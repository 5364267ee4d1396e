#pragma once
// Colours as spectra: the smoothest reflectance that looks like a colour. Palettes and dry layers
// are made of them, so they reach the state: no C library functions, fixed order.

#include <array>
#include <cstddef>

#include "core/optics/spectral/spectrum.h"

namespace pentimento {

/// A reflectance in (0,1) whose linear sRGB under D65 for the 1931 observer is `rgb`, each
/// component first moved into [0.001, 0.999].
///   R = (tanh z + 1)/2; minimise the sum of (z[i+1] - z[i])^2 subject to T R = rgb
/// Scheme: Newton on z and three multipliers, steps halved while the residual grows; |T R - rgb| <
/// 1e-9. Source: Burns, Numerical Methods for Smoothest Reflectance Reconstruction, Color Research
/// and Application 45(1), 2020 ("least hyperbolic tangent slope squared").
/// Departs from it: 10 nm from 380 to 750, as the measured paints are.
Spectrum upsample(const std::array<double, 3>& rgb);

/// Many colours at once, for pictures: eight upsampled corners of sRGB, and the shares of them that
/// give a colour. Colours are met within 0.001, what upsample() moves its corners by. Source:
/// Smits, An RGB-to-Spectrum Conversion for Reflectances, Journal of Graphics Tools 4(4), 1999,
/// with the smoothest spectra for bases.
class ColorBases {
 public:
  static constexpr std::size_t kCount = 8;
  using Shares = std::array<double, kCount>;

  ColorBases();
  /// Corner `i`: bit 0 red, 1 green, 2 blue; 0 is black, 7 white.
  const Spectrum& basis(std::size_t i) const { return basis_[i]; }

 private:
  std::array<Spectrum, kCount> basis_;
};

/// At most four shares, >= 0, of sum 1. `rgb` in [0,1].
ColorBases::Shares base_shares(const std::array<double, 3>& rgb);

}  // namespace pentimento
