#pragma once
// How spectral paint is looked at: the light's and the eye's names, and the interface of the paint.
// Plain values; core/optics/spectral says what they mean.

namespace pentimento {

/// Whether paint is three bands of linear sRGB, or bands of wavelengths.
enum class OpticsKind { kRgb, kSpectral };

enum class Illuminant { kA, kD50, kD55, kD65, kD75, kE, kF2, kF11 };

/// CIE standard observers: 2 degrees (1931) and 10 degrees (1964).
enum class Observer { kCie1931, kCie1964 };

/// The bands of spectral optics unless said otherwise: the fewest whose colours differ by at most
/// 0.5 CIEDE2000 from those of the measured 38, on every mixture of two pigments of the library
/// (docs/optics.md).
inline constexpr int kDefaultBands = 15;

struct Viewing {
  Illuminant illuminant = Illuminant::kD65;
  Observer observer = Observer::kCie1931;
};

/// Saunderson's correction for the interface between paint and air: k1 is what it reflects of the
/// light from outside, k2 of the light from inside. Both 0: no interface.
struct Saunderson {
  double k1 = 0;
  double k2 = 0;
  bool none() const { return k1 == 0 && k2 == 0; }
};

}  // namespace pentimento
