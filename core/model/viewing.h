#pragma once
// How spectral paint is looked at: the names of illuminants and observers, and the interface of the
// paint. Plain values; the code in core/optics/spectral gives them their meaning.

namespace pentimento {

/// Whether paint is three bands of linear sRGB, or bands of wavelengths.
enum class OpticsKind { kRgb, kSpectral };

enum class Illuminant { kA, kD50, kD55, kD65, kD75, kE, kF2, kF11 };

/// CIE standard observers: 2 degrees (1931) and 10 degrees (1964).
enum class Observer { kCie1931, kCie1964 };

/// How many bands spectral optics has by default. It is the smallest number whose colours differ by
/// at most 0.5 CIEDE2000 from those of all 38 measured bands, for every mixture of two pigments of
/// the library (docs/optics.md).
inline constexpr int kDefaultBands = 15;

struct Viewing {
  Illuminant illuminant = Illuminant::kD65;
  Observer observer = Observer::kCie1931;
};

/// Saunderson's correction for the interface between paint and air. The interface reflects the
/// share k1 of the light from outside and k2 of the light from inside, both in [0,1). Both 0: no
/// interface.
struct Saunderson {
  double k1 = 0;
  double k2 = 0;
  bool none() const { return k1 == 0 && k2 == 0; }
};

}  // namespace pentimento
