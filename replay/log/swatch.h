#pragma once
// What a pigment looks like, for lists.

#include <optional>
#include <string>

#include "core/optics/channels.h"
#include "formats/log/tables/events.h"

namespace pentimento {

/// "#rrggbb" of a coat of optical thickness 1 over a ground of that reflectance, 0..1. `paint` has
/// three bands: linear red, green and blue.
std::string coat_hex(const Pigment& paint, double ground);

/// "#rrggbb" of linear light; what is outside 0..1 is cut off.
std::string hex_of(const log::Rgb& linear);

/// Linear light of "#rrggbb"; nothing for other texts.
std::optional<log::Rgb> linear_of_hex(const std::string& hex);

/// The swatch of a header's pigment over white; empty if the library does not know its name.
std::string swatch_hex(const log::PigmentSpec& spec);

}  // namespace pentimento
