#pragma once
// Converts our colour profiles to OpenEXR's chromaticities, and back.

#include <ImfChromaticities.h>
#include <ImfHeader.h>

#include <optional>

#include "formats/color/color_profile.h"

namespace pentimento::exr {

Imf::Chromaticities chromaticities_of(ColorProfile profile);

/// The profile whose primaries and white the file names; nullopt if it names none, or others.
std::optional<ColorProfile> profile_in(const Imf::Header& header);

}  // namespace pentimento::exr
