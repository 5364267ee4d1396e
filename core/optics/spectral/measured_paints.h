#pragma once
// Paints whose absorption and scattering were measured per wavelength: nineteen Golden Heavy Body
// acrylics (optics/data/SOURCE.md). Their K and S are relative to titanium white's scattering; what
// film has optical thickness 1 the source leaves open, and kMeasuredScale settles.

#include <span>
#include <string>
#include <string_view>

#include "core/optics/spectral/spectrum.h"

namespace pentimento {

/// Absorption and scattering for optical thickness 1, per sample of a spectrum.
struct SpectralPaint {
  std::string name;
  Spectrum K{};
  Spectrum S{};
};

/// K and S of the library over those of the table. At 12 titanium white hides a contrast of 95 % at
/// thickness 1.4 and the median paint at 5, which is two passes of a full brush (docs/optics.md).
inline constexpr double kMeasuredScale = 12;

/// The interface through which they were measured, and are looked at: its k2. Its k1 is the gloss
/// that the picture adds itself.
inline constexpr double kMeasuredK1 = 0.03;
inline constexpr double kMeasuredK2 = 0.65;

/// In the order of the table; names as "Golden Cobalt Blue".
std::span<const SpectralPaint> measured_paints();

/// The measured paint of that name, written as for find_library_pigment(), or nullptr.
const SpectralPaint* find_measured_paint(std::string_view name);

/// The table's text: pigment, colour index, K or S, 38 values a line.
std::string_view measured_paint_table();

}  // namespace pentimento
