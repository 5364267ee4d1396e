#pragma once
// Our colour profiles as OpenEXR's chromaticities, and back.

#include <ImfChromaticities.h>
#include <ImfHeader.h>

#include <optional>

#include "formats/color/color_profile.h"

namespace pentimento::exr {

Imf::Chromaticities chromaticities_of(ColorProfile profile);

/// Whose primaries and white the file says its light has; nullopt if it does not say, or others.
std::optional<ColorProfile> profile_in(const Imf::Header& header);

}  // namespace pentimento::exr
