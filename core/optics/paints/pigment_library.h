#pragma once
// Pigments that a log may ask for by name. Three sources:
// - the twelve watercolours of Curtis et al. 1997, fig. 5 (K and S per linear RGB band, optical
//   thickness 1), under their published names;
// - oil colours every painter expects, from a picked colour over white and an opacity by the
//   inverse Kubelka-Munk formula (kubelka_munk.h); colour and opacity stand beside each;
// - measured paints, per wavelength (spectral/measured_paints.h).

#include <span>
#include <string_view>

#include "core/optics/channels.h"

namespace pentimento {

/// The library's RGB pigment called `name`, or nullptr. Case, apostrophes, and '-' or '_' for a
/// space do not matter ("hookers-green" is "Hooker's Green"). Three bands, linear RGB.
const Pigment* find_library_pigment(std::string_view name);

/// Whether the library has a pigment of that name, RGB or measured.
bool in_pigment_library(std::string_view name);

/// Names of the RGB pigments: Curtis' twelve, then the oil colours.
std::span<const std::string_view> rgb_pigment_names();
/// All names: the RGB pigments, then the measured paints.
std::span<const std::string_view> library_pigment_names();

}  // namespace pentimento
