#pragma once
// PNG chunks (ISO/IEC 15948, sections 5 and 11) as bytes.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "formats/color/color_profile.h"
#include "formats/io/picture_file.h"

namespace pentimento::png {

using Bytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

/// Length, type, data and CRC.
Bytes chunk(std::string_view type, std::span<const std::uint8_t> data);
/// What stands before the first IDAT: signature, IHDR (RGB), sRGB or iCCP, pHYs (if
/// `dpi` > 0), text.
/// Errors: kUsage for a provenance key that PNG cannot hold.
Result<Bytes> file_head(int width, int height, int bit_depth, ColorProfile profile, double dpi,
                        const Provenance& provenance);

}  // namespace pentimento::png
