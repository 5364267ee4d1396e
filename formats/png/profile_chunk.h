#pragma once
// The iCCP chunk of PNG (ISO/IEC 15948, 11.3.3.3): a name and a deflated ICC profile.

#include <cstdint>
#include <span>
#include <vector>

#include "formats/color/icc_profile.h"

namespace pentimento::png {

/// The chunk's data for `profile`.
std::vector<std::uint8_t> iccp_data(ColorProfile profile);

/// What the profile in a chunk's data says. If the profile is broken, has no title or is larger
/// than 4 MiB, the title is the name in the chunk.
IccDescription describe_iccp(std::span<const std::uint8_t> data);

}  // namespace pentimento::png
