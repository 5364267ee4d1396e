#pragma once
// Pigments that a log may ask for by name. Two sources:
// - the twelve watercolours of Curtis et al. 1997, fig. 5 (K and S per linear RGB band, optical
//   thickness 1), under their published names;
// - oil colours every painter expects, from a picked colour over white and an opacity by the
//   inverse Kubelka-Munk formula (kubelka_munk.h); colour and opacity stand beside each.

#include <span>
#include <string_view>

#include "core/optics/channels.h"

namespace pentimento {

/// The library's pigment called `name`, or nullptr. Case, apostrophes, and '-' or '_' for a space
/// do not matter ("hookers-green" is "Hooker's Green"). Three bands, linear RGB.
const Pigment* find_library_pigment(std::string_view name);

/// All names, in the library's order: Curtis' twelve, then the oil colours.
std::span<const std::string_view> library_pigment_names();

}  // namespace pentimento
