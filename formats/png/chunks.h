#pragma once
// PNG chunks (ISO/IEC 15948, sections 5 and 11) as bytes.

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "formats/color/color_profile.h"
#include "formats/io/picture_file.h"

namespace pentimento::png {

using PngBytes = std::vector<std::uint8_t>;

inline constexpr std::uint8_t kSignature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};

/// Length, type, data and CRC.
PngBytes chunk(std::string_view type, std::span<const std::uint8_t> data);
/// What a PNG file says about itself before its pixels.
struct Head {
  int width = 0, height = 0;
  int bit_depth = 8;
  int channels = 3;                     // 1: grey
  std::optional<ColorProfile> profile;  // none: the samples are no colours
  double dpi = 0;                       // 0: not said
};
/// The bytes before the first IDAT: signature, IHDR, sRGB or iCCP, pHYs, text.
/// Errors: kUsage for a provenance key that PNG cannot hold.
Result<PngBytes> file_head(const Head& head, const Provenance& provenance);

}  // namespace pentimento::png
