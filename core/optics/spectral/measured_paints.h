#pragma once
// Paints whose absorption and scattering were measured per wavelength: nineteen Golden Heavy Body
// acrylics (optics/data/SOURCE.md). Their K and S are relative to the scattering of titanium white.
// The source does not say which film has optical thickness 1; kMeasuredScale decides that.

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

/// Factor from K and S of the table to K and S of the library. At 12 titanium white hides a
/// contrast of 95 % at thickness 1.4 and the median paint at 5, which is two passes of a full brush
/// (docs/optics.md).
inline constexpr double kMeasuredScale = 12;

/// The interface through which the paints were measured. Pictures use its k2; in place of k1 they
/// have their own gloss.
inline constexpr double kMeasuredK1 = 0.03;
inline constexpr double kMeasuredK2 = 0.65;

/// All measured paints, in the order of the table. Names are like "Golden Cobalt Blue".
std::span<const SpectralPaint> measured_paints();

/// The measured paint of that name, written as for find_library_pigment(), or nullptr.
const SpectralPaint* find_measured_paint(std::string_view name);

/// The table's text: pigment, colour index, K or S, 38 values a line.
std::string_view measured_paint_table();

}  // namespace pentimento
